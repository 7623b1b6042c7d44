#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "io/errors.hpp"
#include "logs/log_report.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {

logs::RecordedFacts read_facts(const std::string& path, const std::string& copy,
                               league::FrameSource source) {
  try {
    return logs::facts_of(copy, source);
  } catch (const league::LogError& error) {
    throw io::InputError({}, "", logs::text_of(error, copy, path));
  }
}

int info_verb(const InfoArguments& arguments) {
  const logs::RecordedFacts facts = read_facts(arguments.log, logs::seekable_log(arguments.log));
  fmt::print("{}\n",
             arguments.json ? logs::info_json(facts) : logs::info_text(facts, arguments.commands));
  io::write_message(stderr, logs::damage_text(arguments.log, facts));
  return facts.log.damage ? io::kBadInput : io::kDone;
}

void add_info_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("info", "Summarise an SSL log.");
  auto arguments = std::make_shared<InfoArguments>();
  verb->add_option("LOG", arguments->log, "A .log or .log.gz file.")->required();
  verb->add_flag("--commands", arguments->commands, "List every command with its time.");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer(
      "If the log is damaged, reports what precedes the damage, names its position on stderr and\n"
      "exits with code 2.\n\n"
      "Example:\n  autoref info game.log.gz --commands");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return info_verb(*arguments); }; });
}

}  // namespace autoref::app
