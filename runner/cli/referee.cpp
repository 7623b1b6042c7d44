#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "runner/cli/command_line.hpp"
#include "runner/cli/output_file.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/logs/log_report.hpp"
#include "runner/logs/user_log.hpp"
#include "runner/settings/assignments.hpp"
#include "runner/settings/fields.hpp"
#include "runner/settings/match_rules.hpp"

namespace autoref::runner {
namespace {

// What the log tells of the game; the rest is the rule book's.
void take_over(const RecordedFacts& facts, GameConfiguration& game) {
  if (facts.log.field) game.field = *facts.log.field;
  if (facts.half_s) game.match.half_s = *facts.half_s;
  if (facts.halves > 0) game.match.halves = facts.halves;
  if (facts.first_kickoff) game.match.first_kickoff = *facts.first_kickoff;
  game.a.robots = std::max(1, facts.robots[Side::kWest]);
  game.b.robots = std::max(1, facts.robots[Side::kEast]);
}

GameConfiguration game_of(const RefereeArguments& arguments, const RecordedFacts& facts) {
  GameConfiguration game;
  blame("--rules", [&] { choose_rules(arguments.rules, game); });
  take_over(facts, game);
  const auto set = [&](const std::string& flag, const std::string& path, const std::string& value) {
    if (!value.empty()) blame(flag, [&] { set_by_path(game, path, value); });
  };
  set("--camera", "sim.camera", arguments.camera);
  set("--first-kickoff", "match.first_kickoff", arguments.first_kickoff);
  assign_all(assignments_in(arguments.sets), game);
  return game;
}

}  // namespace

int referee_verb(const RefereeArguments& arguments) {
  check_outputs({{"--events", arguments.events}}, {arguments.log});
  std::optional<PendingFile> events;
  open_output(events, "--events", arguments.events);
  const RecordedFacts facts = read_facts(arguments.log);
  if (facts.log.frames == 0) {
    throw InputError({arguments.log}, "", "holds no vision packets of 2014 to judge");
  }
  const GameConfiguration game = game_of(arguments, facts);
  const LogRefereeResult evaluation =
      referee_log(arguments.log, facts, referee_configuration(game));
  if (events) events->commit(evaluation.events);
  fmt::print("{}\n", arguments.json ? referee_log_json(evaluation, facts)
                                    : referee_log_text(evaluation, facts));
  write_message(stderr, damage_text(arguments.log, facts.log));
  return facts.log.damage ? kBadInput : kDone;
}

void add_referee_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "referee", "Judge a recorded game from its vision packets, beside the recorded commands.");
  auto arguments = std::make_shared<RefereeArguments>();
  verb->add_option("--log", arguments->log, "A .log or .log.gz file.")
      ->type_name("FILE")
      ->required();
  verb->add_option("--rules", arguments->rules, "Rule book (autoref rules lists them).")
      ->type_name("BOOK")
      ->capture_default_str();
  verb->add_option("--first-kickoff", arguments->first_kickoff,
                   "Side of the first kick-off instead of the recorded one.")
      ->type_name("west|east");
  verb->add_option("--camera", arguments->camera, "How noisy vision is, by a camera preset.")
      ->type_name("PRESET");
  add_set_option(*verb, arguments->sets);
  verb->add_option("--events", arguments->events,
                   "Write AutoRef's decisions to FILE, one JSON object a line.")
      ->type_name("FILE");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer(
      "Field, length of a half, first kick-off and robots come from the log where it has them.\n"
      "Yellow is west; where the log says that blue defends the goal at -x, it is turned round.\n\n"
      "Example:\n  autoref referee --log game.log.gz --camera paper --events events.jsonl");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return referee_verb(*arguments); }; });
}

}  // namespace autoref::runner
