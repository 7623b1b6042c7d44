#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/cli/command_line.hpp"
#include "runner/cli/controlled.hpp"
#include "runner/cli/play_from.hpp"
#include "runner/cli/play_one.hpp"
#include "runner/cli/scenario_argument.hpp"
#include "runner/experiments/kinds/scenario.hpp"
#include "runner/experiments/kinds/scenario_reader.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/assignments.hpp"
#include "runner/settings/fields.hpp"
#include "runner/settings/resolved.hpp"
#include "runner/settings/robot_types.hpp"
#include "runner/team_programs/program_games.hpp"

namespace autoref::runner {
namespace {

void refuse_needless_commands(const PlayArguments& arguments, const GameSettings& game) {
  if (arguments.commands.empty() || has_programs(resolved(game))) return;
  throw InputError({"--commands"}, "",
                   "neither team of the scenario is a program or on the network");
}

const std::string& scenario_of(const PlayArguments& arguments) {
  if (!arguments.file.empty()) return arguments.file;
  throw InputError({}, "", "give a scenario of kind game, or --from LOG@SECONDS");
}

}  // namespace

GameSettings game_in(const std::string& file, const std::string& seed,
                     const Assignments& assignments) {
  Scenario scenario = read_scenario(file, assignments);
  auto* game = std::get_if<GameSettings>(&scenario.content);
  if (game == nullptr) {
    throw InputError({file}, "kind",
                     fmt::format("this is of kind {}, not a game; run it with: autoref {} {}",
                                 kind_of(scenario), verb_of(scenario), file));
  }
  if (!seed.empty()) blame("--seed", [&] { set_by_path(*game, "seed", seed); });
  return *game;
}

// The files that a game is read from: the scenario, recorded commands, and the robot type files
// named by the scenario or by --set.
std::vector<std::string> inputs_of(const std::string& file, const std::string& commands,
                                   const Assignments& assignments) {
  std::vector<std::string> inputs;
  if (!file.empty()) {
    inputs = type_files_in(file);
    inputs.push_back(file);
  }
  if (!commands.empty()) inputs.push_back(commands);
  for (const Assignment& assignment : assignments) {
    if (is_type_file(assignment.value)) inputs.push_back(assignment.value);
  }
  return inputs;
}

int play_verb(const PlayArguments& arguments) {
  const Assignments assignments = assignments_in(arguments.sets);
  GameSettings game = arguments.from.empty()
                          ? game_in(scenario_of(arguments), arguments.seed, assignments)
                          : game_from_log(arguments, assignments);
  refuse_needless_commands(arguments, game);
  if (!arguments.game_controller.empty()) game.match.control = referee::Control::kGameController;
  std::vector<std::string> inputs = inputs_of(arguments.file, arguments.commands, assignments);
  if (!arguments.from.empty()) inputs.push_back(instant_in(arguments.from).log);
  GameRecord record;
  blame(arguments.file.empty() ? "--from" : arguments.file, [&] {
    record = game.match.control == referee::Control::kGameController
                 ? play_controlled(resolved(game), arguments, inputs)
                 : play_one(resolved(game), arguments.output, inputs, {arguments.commands});
  });
  return record.status == Status::kVoid ? kTooManyVoid : kDone;
}

void add_play_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("play", "Play one refereed game.");
  auto arguments = std::make_shared<PlayArguments>();
  add_scenario_argument(*verb, arguments->file, "Scenario of kind game; optional with --from.")
      ->required(false);
  verb->add_option("--from", arguments->from,
                   "Begin where this SSL log is at that time, in seconds from its start: robots, "
                   "ball and pending restart are the log's, score and clock start at 0.")
      ->type_name("LOG@SECONDS");
  verb->add_option("--seed", arguments->seed, "Seed, overriding the scenario.")->type_name("N");
  add_set_option(*verb, arguments->sets);
  verb->add_option("--commands", arguments->commands,
                   "Recorded commands to play instead of the teams' programs (--record).")
      ->type_name("FILE");
  verb->add_option("--game-controller", arguments->game_controller,
                   "Let the league's game controller, in its CI mode, command the game "
                   "(match.control=game-controller); 127.0.0.1:10009 by default.")
      ->type_name("HOST[:PORT]")
      ->excludes("--from");
  add_output_options(*verb, arguments->output);
  add_speed_option(*verb, arguments->output);
  verb->footer(
      "Examples:\n  autoref play scenarios/paper-game.yaml --seed 7 --set b.robots=5 "
      "--set match.half_s=60\n"
      "  autoref play --from game.log.gz@83.2 --set match.rules=2026-b --view game.html");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return play_verb(*arguments); }; });
}

}  // namespace autoref::runner
