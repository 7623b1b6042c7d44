// Settings, events, verbs, exit codes and ports.
#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "referee/event.hpp"
#include "runner/io/errors.hpp"
#include "runner/live/live_options.hpp"
#include "runner/settings/fields.hpp"
#include "tests/runner/cli/answer.hpp"
#include "tests/runner/support/written_names.hpp"
#include "tests/stability/promised_names.hpp"

namespace autoref::runner {

// Of a game in which one robot has settings of its own.
Names setting_names() {
  GameSettings game;
  Names names;
  for (const Setting& setting : settings_with(game, "a.players.3.handicap")) {
    names.push_back(setting.path);
    for (const std::string& word : setting.words) names.push_back(setting.path + " = " + word);
  }
  return names;
}

Names written_names() {
  Names names;
  for (const auto& artefacts : {written_csv(), written_plots(), written_json()}) {
    for (const Artefact& artefact : artefacts)
      for (const std::string& name : artefact.names())
        names.push_back(artefact.section + ": " + name);
  }
  return names;
}

Names event_names() {
  Names names;
  for (const referee::EventEntry& entry : referee::event_table()) names.emplace_back(entry.name);
  return names;
}

// From the completion script for bash, which has a line for each verb:
//   'team new') words='-h --help --language' verbs='' ;;
Names command_line_names() {
  const std::regex line_of_verb(R"( *'([a-z -]*)'\) words='([^']*)' verbs='[^']*' ;;)");
  Names names;
  std::istringstream script(answer_to({"completion", "bash"}).out);
  for (std::string line; std::getline(script, line);) {
    std::smatch parts;
    if (!std::regex_match(line, parts, line_of_verb)) continue;
    const std::string verb = parts[1];
    if (!verb.empty()) names.push_back(verb);
    std::istringstream options(parts[2]);
    for (std::string option; options >> option;)
      names.push_back(verb.empty() ? option : verb + " " + option);
  }
  return names;
}

Names exit_code_names() {
  return {fmt::format("{} done", kDone),
          fmt::format("{} bad input", kBadInput),
          fmt::format("{} too many void games", kTooManyVoid),
          fmt::format("{} a replayed game differs", kDifferent),
          fmt::format("{} internal error", kInternal),
          fmt::format("{} input or output failed", kInputOutput),
          fmt::format("{} interrupted", kInterrupted)};
}

Names network_names() {
  const LivePorts ports;
  return {fmt::format("vision {}:{}", kVisionGroup, ports.vision),
          fmt::format("referee {}:{}", kRefereeGroup, ports.referee),
          fmt::format("tracker {}:{}", kVisionGroup, ports.tracker),
          fmt::format("control {}", ports.control),
          fmt::format("blue {}", ports.blue),
          fmt::format("yellow {}", ports.yellow),
          fmt::format("grsim {}", ports.grsim),
          fmt::format("grsim status blue {}", ports.grsim_status_blue),
          fmt::format("grsim status yellow {}", ports.grsim_status_yellow)};
}

}  // namespace autoref::runner
