// Settings, events, verbs, exit codes and ports.
#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "app/former_names.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "live/live_options.hpp"
#include "referee/event.hpp"
#include "tests/app/answer.hpp"
#include "tests/stability/promised_names.hpp"
#include "tests/support/written_names.hpp"

namespace autoref::stability {

// Of a game in which one robot has settings of its own.
Names setting_names() {
  game::GameSettings game;
  Names names;
  for (const game::Setting& setting : game::settings_with(game, "a.players.3.handicap")) {
    names.push_back(setting.path);
    for (const std::string& word : setting.allowed_words)
      names.push_back(setting.path + " = " + word);
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
  for (const std::string& name : calls_columns()) names.push_back("Calls: " + name);
  return names;
}

Names event_names() {
  Names names;
  for (const referee::EventEntry& entry : referee::event_table()) names.emplace_back(entry.name);
  return names;
}

// From the reference page of verbs, which has a section for each verb, with a row for each option:
//   ## autoref team new
//   | `-h`, `--help` | Print this help message and exit |
Names command_line_names() {
  const std::regex option_name(R"(`(-[a-z-]+)`)");
  Names names;
  std::string verb;
  std::istringstream page(app::answer_to({"reference", "verbs"}).out);
  for (std::string line; std::getline(page, line);) {
    constexpr std::string_view kSection = "## autoref ";
    if (line.starts_with(kSection)) names.push_back(verb = line.substr(kSection.size()));
    if (!line.starts_with("| `-")) continue;
    const std::string cell = line.substr(0, line.find(" | "));
    for (std::sregex_iterator name(cell.begin(), cell.end(), option_name), end; name != end; ++name)
      names.push_back(verb.empty() ? name->str(1) : verb + " " + name->str(1));
  }
  // A former name calls the same verb.
  for (const app::FormerName& name : app::former_names())
    names.push_back(fmt::format("{} is {}", name.former, name.present));
  for (const Names& former : {Names{"draw", "FILE", "--situation", "NAME"},
                              Names{"referee", "--live"}, Names{"referee", "./LOG"}})
    names.push_back(fmt::format("{} is {}", fmt::join(former, " "),
                                fmt::join(app::with_present_names(former), " ")));
  return names;
}

Names exit_code_names() {
  return {fmt::format("{} done", io::kDone),
          fmt::format("{} bad input", io::kBadInput),
          fmt::format("{} too many void games", io::kTooManyVoid),
          fmt::format("{} a replayed game differs", io::kDifferent),
          fmt::format("{} internal error", io::kInternal),
          fmt::format("{} input or output failed", io::kInputOutput),
          fmt::format("{} interrupted", io::kInterrupted)};
}

Names network_names() {
  const live::LivePorts ports;
  return {fmt::format("vision {}:{}", live::kVisionGroup, ports.vision),
          fmt::format("referee {}:{}", live::kRefereeGroup, ports.referee),
          fmt::format("tracker {}:{}", live::kVisionGroup, ports.tracker),
          fmt::format("control {}", ports.control),
          fmt::format("blue {}", ports.blue),
          fmt::format("yellow {}", ports.yellow),
          fmt::format("grsim {}", ports.grsim),
          fmt::format("grsim status blue {}", ports.grsim_status_blue),
          fmt::format("grsim status yellow {}", ports.grsim_status_yellow)};
}

}  // namespace autoref::stability
