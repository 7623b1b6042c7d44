#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/cli/command_line.hpp"
#include "runner/io/errors.hpp"
#include "runner/logs/log_report.hpp"
#include "runner/logs/user_log.hpp"

namespace autoref::runner {

RecordedFacts read_facts(const std::string& path, const std::string& copy,
                         league::FrameSource source) {
  try {
    return facts_of(copy, source);
  } catch (const league::LogError& error) {
    throw InputError({}, "", text_of(error, copy, path));
  }
}

int info_verb(const InfoArguments& arguments) {
  const RecordedFacts facts = read_facts(arguments.log, seekable_log(arguments.log));
  fmt::print("{}\n", arguments.json ? info_json(facts) : info_text(facts, arguments.commands));
  write_message(stderr, damage_text(arguments.log, facts));
  return facts.log.damage ? kBadInput : kDone;
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

}  // namespace autoref::runner
