#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/game/controlled.hpp"
#include "app/game/play_from.hpp"
#include "app/game/play_one.hpp"
#include "app/scenario_argument.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/resolved.hpp"
#include "game/settings/robot_types.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

void refuse_needless_commands(const PlayArguments& arguments, const game::GameSettings& game) {
  if (arguments.commands.empty() || game::has_programs(game::resolved(game))) return;
  throw io::InputError({"--commands"}, "",
                       "neither team of the scenario is a program or on the network");
}

const std::string& scenario_of(const PlayArguments& arguments) {
  if (!arguments.file.empty()) return arguments.file;
  throw io::InputError({}, "", "give a scenario of kind game, or --from LOG@SECONDS");
}

}  // namespace

game::GameSettings game_in(const std::string& file, const std::string& seed,
                           const game::Assignments& assignments) {
  experiments::Scenario scenario = experiments::read_scenario(file, assignments);
  auto* game = std::get_if<game::GameSettings>(&scenario.content);
  if (game == nullptr) {
    throw io::InputError(
        {file}, "kind",
        fmt::format("this is of kind {}, not a game; run it with: autoref {} {}",
                    experiments::kind_of(scenario), experiments::verb_of(scenario), file));
  }
  if (!seed.empty()) game::blame("--seed", [&] { game::set_by_path(*game, "seed", seed); });
  return *game;
}

// The files that a game is read from: the scenario, recorded commands, and the robot type files
// named by the scenario or by --set.
std::vector<std::string> inputs_of(const std::string& file, const std::string& commands,
                                   const game::Assignments& assignments) {
  std::vector<std::string> inputs;
  if (!file.empty()) {
    inputs = game::type_files_in(file);
    inputs.push_back(file);
  }
  if (!commands.empty()) inputs.push_back(commands);
  for (const game::Assignment& assignment : assignments) {
    if (game::is_type_file(assignment.value)) inputs.push_back(assignment.value);
  }
  return inputs;
}

int play_verb(const PlayArguments& arguments) {
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  game::GameSettings game = arguments.from.empty()
                                ? game_in(scenario_of(arguments), arguments.seed, assignments)
                                : game_from_log(arguments, assignments);
  refuse_needless_commands(arguments, game);
  if (!arguments.game_controller.empty()) game.match.control = referee::Control::kGameController;
  std::vector<std::string> inputs = inputs_of(arguments.file, arguments.commands, assignments);
  if (!arguments.from.empty()) inputs.push_back(instant_in(arguments.from).log);
  game::GameRecord record;
  game::blame(arguments.file.empty() ? "--from" : arguments.file, [&] {
    record = game.match.control == referee::Control::kGameController
                 ? play_controlled(game::resolved(game), arguments, inputs)
                 : play_one(game::resolved(game), arguments.output, inputs, {arguments.commands});
  });
  return record.status == game::Status::kVoid ? io::kTooManyVoid : io::kDone;
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

}  // namespace autoref::app
