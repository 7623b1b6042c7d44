#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>

#include "app/game/continuations.hpp"
#include "app/game/log_start.hpp"
#include "app/game/play_one.hpp"
#include "app/game/scenario_game.hpp"
#include "app/network_flags.hpp"
#include "app/scenario_argument.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/errors.hpp"
#include "live/controller/controlled_game.hpp"

namespace autoref::app {
namespace {

struct PlayArguments {
  std::string file;   // empty: the default settings; only with --from
  std::string from;   // LOG@SECONDS where the game begins; empty: with a kick-off
  std::string ghost;  // colour of the side that repeats the log; empty: neither
  ManyGames many;
  std::string seed;               // empty: the scenario's seed
  std::vector<std::string> sets;  // "key=value"
  std::string commands;           // file of recorded commands; empty: the programs play
  std::string game_controller;    // HOST[:PORT] of the controller in command; empty: the default
  GameOutput output;
};

void refuse_needless_commands(const PlayArguments& arguments, const game::GameSettings& game) {
  if (arguments.commands.empty() || game::has_programs(game::resolved(game))) return;
  throw io::InputError({"--commands"}, "",
                       "neither team of the scenario is a program or on the network, so recorded "
                       "commands cannot be played");
}

const std::string& scenario_of(const PlayArguments& arguments) {
  if (!arguments.file.empty()) return arguments.file;
  throw io::InputError({}, "", "give a scenario of kind game, or --from LOG@SECONDS");
}

void print_outcome(const live::ControlledGameReport& report) {
  io::write_message(stderr,
                    fmt::format("AutoRef's events: {} accepted, {} rejected, {} not answered\n",
                                report.accepted, report.rejected, report.unanswered));
  if (!report.problem.empty())
    io::write_message(stderr, fmt::format("The port for automatic referees: {}\n", report.problem));
  io::write_message(stderr, report.differences);
}

// Like play_one(), but reports on stderr where the controller's decisions differed from AutoRef's.
game::GameRecord play_controlled(const game::GameConfiguration& game,
                                 const PlayArguments& arguments,
                                 const std::vector<std::string>& inputs) {
  live::ControllerPlace place;
  if (!arguments.game_controller.empty())
    place.ci = controller_address(arguments.game_controller, place.ci.port);
  const std::optional<double> frames_per_s = pace_of(game, arguments.output);
  live::ControlledGame controlled(game, place, is_interrupted);
  GamePlayer player;
  player.play = [&](const game::Observers& observers, game::GamePrograms& programs) {
    return controlled.play(observers, programs, frames_per_s);
  };
  try {
    game::GameRecord record =
        play_one(game, arguments.output, inputs, {arguments.commands}, player);
    print_outcome(controlled.report());
    return record;
  } catch (const io::Interrupted&) {
    print_outcome(controlled.report());
    throw;
  }
}

int code_of(const game::GameRecord& record) {
  return record.status == game::Status::kVoid ? io::kTooManyVoid : io::kDone;
}

// Only one game at a time is written, shown or paced.
void refuse_outputs_of_many(const PlayArguments& arguments) {
  const GameOutput& output = arguments.output;
  const std::vector<std::pair<const char*, bool>> given = {
      {"--commands", !arguments.commands.empty()},
      {"--events", !output.events.empty()},
      {"--game-events", !output.game_events.empty()},
      {"--chains", !output.chains.empty()},
      {"--actions", !output.actions.empty()},
      {"--log", !output.log.empty()},
      {"--view", !output.view.empty()},
      {"--record", !output.record.empty()},
      {"--web", !output.web.address.empty()},
      {"--speed", !output.speed.empty()}};
  for (const auto& [flag, is_given] : given) {
    if (!is_given) continue;
    throw io::InputError(
        {flag}, "", "works for one game only; leave out --games and choose the game with --seed");
  }
}

int play_from_log(const PlayArguments& arguments) {
  const LogInstant instant = instant_in(arguments.from);
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  if (arguments.many.games > 0) refuse_outputs_of_many(arguments);
  const GameFromLog from =
      game_from_log(instant, arguments.file, arguments.seed, arguments.ghost, assignments);
  refuse_needless_commands(arguments, from.game);
  std::vector<std::string> inputs = inputs_of(arguments.file, arguments.commands, assignments);
  inputs.push_back(instant.log);
  int code = io::kDone;
  game::locate_errors("--from", [&] {
    const game::GameConfiguration game = game::resolved(from.game);
    if (arguments.many.games > 0) {
      ManyGames many = arguments.many;
      many.json = arguments.output.json;
      code = play_continuations(game, many, instant, from.sequel);
      return;
    }
    code = code_of(play_one(game, arguments.output, inputs, {arguments.commands}));
    if (from.sequel && !arguments.output.json) fmt::print("{}\n", text_of(*from.sequel));
  });
  return code;
}

int play_scenario(const PlayArguments& arguments) {
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  game::GameSettings game = game_in(scenario_of(arguments), arguments.seed, assignments);
  refuse_needless_commands(arguments, game);
  if (!arguments.game_controller.empty()) game.match.control = referee::Control::kGameController;
  const std::vector<std::string> inputs =
      inputs_of(arguments.file, arguments.commands, assignments);
  game::GameRecord record;
  game::locate_errors(arguments.file, [&] {
    record = game.match.control == referee::Control::kGameController
                 ? play_controlled(game::resolved(game), arguments, inputs)
                 : play_one(game::resolved(game), arguments.output, inputs, {arguments.commands});
  });
  return code_of(record);
}

int play_verb(const PlayArguments& arguments) {
  return arguments.from.empty() ? play_scenario(arguments) : play_from_log(arguments);
}

void add_from_options(CLI::App& verb, PlayArguments& arguments) {
  CLI::Option* from =
      verb.add_option("--from", arguments.from,
                      "Begin with the state of this SSL log at that time, in seconds from its "
                      "start: robots, ball, pending restart, score, clock, cards and timeouts.")
          ->type_name("LOG@SECONDS");
  verb.add_option("--games", arguments.many.games,
                  "Play this many games from there, with consecutive seeds from --seed on, and "
                  "print how often each outcome occurs.")
      ->type_name("N")
      ->check(CLI::Range(1, kMostContinuations))
      ->needs(from);
  verb.add_option(
          "--ghost", arguments.ghost,
          "This side repeats its recorded motion, and so does the ball until the first touch "
          "that differs. Play must be on at that time; the game ends 2 s after the recorded "
          "play.")
      ->type_name("yellow|blue")
      ->check(one_of({"yellow", "blue"}))
      ->needs(from);
  add_workers_option(verb, arguments.many.workers, "Games played in parallel with --games.");
}

}  // namespace

void add_play_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("play", "Play one refereed game.");
  auto arguments = std::make_shared<PlayArguments>();
  add_scenario_argument(*verb, arguments->file, "Scenario of kind game; optional with --from.")
      ->required(false);
  add_from_options(*verb, *arguments);
  verb->add_option("--seed", arguments->seed, "Seed, overriding the scenario.")->type_name("N");
  add_set_option(*verb, arguments->sets);
  verb->add_option(
          "--commands", arguments->commands,
          "Play these recorded commands (--record) instead of running the teams' programs.")
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
      "  autoref play --from game.log.gz@83.2 --view game.html\n"
      "  autoref play --from game.log.gz@83.2 --games 200 --set b.strategy=cobalt\n"
      "  autoref play --from game.log.gz@81 --ghost yellow --set b.strategy=cobalt");
  choose(*verb, chosen, arguments, play_verb);
}

}  // namespace autoref::app
