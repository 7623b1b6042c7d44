#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "logs/log_report.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {
namespace {

struct InfoArguments {
  std::string log;
  bool commands = false;
  bool json = false;
};

int info_verb(const InfoArguments& arguments) {
  const logs::RecordedFacts facts =
      logs::read_facts(arguments.log, logs::seekable_log(arguments.log));
  fmt::print("{}\n",
             arguments.json ? logs::info_json(facts) : logs::info_text(facts, arguments.commands));
  io::write_message(stderr, logs::damage_text(arguments.log, facts));
  return facts.log.damage ? io::kBadInput : io::kDone;
}

}  // namespace

void add_info_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("info", "Summarise an SSL log.");
  auto arguments = std::make_shared<InfoArguments>();
  add_log_argument(*verb, arguments->log);
  verb->add_flag("--commands", arguments->commands, "List every command with its time.");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "If the log is damaged, summarises the part before the damage, prints its position on\n"
      "stderr and exits with code 2.\n\n"
      "Example:\n  autoref log info game.log.gz --commands");
  choose(*verb, chosen, arguments, info_verb);
}

}  // namespace autoref::app
