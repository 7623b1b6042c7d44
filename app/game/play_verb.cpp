#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "app/game/play_one.hpp"
#include "app/game/scenario_game.hpp"
#include "app/network_flags.hpp"
#include "app/scenario_argument.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "live/controller/controlled_game.hpp"
#include "logs/log_game.hpp"
#include "logs/logged_state.hpp"
#include "logs/user_log.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::app {
namespace {

struct PlayArguments {
  std::string file;               // empty: the default settings; only with --from
  std::string from;               // LOG@SECONDS where the game begins; empty: with a kick-off
  std::string seed;               // empty: the scenario's seed
  std::vector<std::string> sets;  // "key=value"
  std::string commands;           // file of recorded commands; empty: the programs play
  std::string game_controller;    // HOST[:PORT] of the controller in command; empty: the default
  GameOutput output;
};

// A point in a log at which games begin.
struct PlayedInstant {
  std::string log;
  double at_s = 0;  // time since the start of the log
};

game::TeamSettings& team_in(game::GameSettings& game, Side side) {
  return side == game.match.a_plays ? game.a : game.b;
}

// Settings that the user does not set are taken from the log.
void take_defaults(const logs::LoggedState& logged, game::GameSettings& game) {
  const auto is_given = [&game](std::string_view path) {
    return std::any_of(game.given.begin(), game.given.end(),
                       [path](const std::string& one) { return one.starts_with(path); });
  };
  if (!is_given("field.")) game.field = logs::field_in(logged.log, game.field);
  for (const Side side : kSides) {
    if (is_given(side == game.match.a_plays ? "teams.a.robots" : "teams.b.robots")) continue;
    const game::StartingRobots& robots = logged.start.robots[side];
    team_in(game, side).robots = std::max(1, static_cast<int>(robots.size()));
  }
}

void keep_inside_walls(game::StartState& start, const Field& field) {
  const auto clamped = [&field](const Vec2& position_m, double radius_m) {
    const double x_m = field.wall_x_m() - radius_m;
    const double y_m = field.wall_y_m() - radius_m;
    return Vec2(std::clamp(position_m.x(), -x_m, x_m), std::clamp(position_m.y(), -y_m, y_m));
  };
  for (game::StartingRobots& robots : start.robots.values) {
    for (sim::RobotState& robot : robots)
      robot.position_m = clamped(robot.position_m, kRobotRadius_m);
  }
  start.ball.position_m = clamped(start.ball.position_m, kBallRadius_m);
}

game::GameSettings scenario_or_defaults(const PlayArguments& arguments,
                                        const game::Assignments& assignments) {
  if (!arguments.file.empty()) return game_in(arguments.file, arguments.seed, assignments);
  game::GameSettings game;
  game::assign_all(assignments, game);
  if (!arguments.seed.empty())
    game::locate_errors("--seed", [&] { game::set_by_path(game, "seed", arguments.seed); });
  return game;
}

// Parses LOG@SECONDS. Throws InputError naming --from.
PlayedInstant instant_in(const std::string& from) {
  const std::size_t at = from.rfind('@');
  const std::optional<double> seconds =
      at == std::string::npos ? std::nullopt : io::number_in(from.substr(at + 1));
  if (!seconds || at == 0) {
    throw io::InputError(
        {"--from"}, "",
        fmt::format("expected LOG@SECONDS, such as game.log.gz@83.2, found '{}'", from));
  }
  return {from.substr(0, at), *seconds};
}

// The game of `arguments.file`, beginning with the log's state at that time. Without a scenario,
// the field and the numbers of robots come from the log unless they are set. Throws InputError.
game::GameSettings game_from_log(const PlayArguments& arguments,
                                 const game::Assignments& assignments) {
  const PlayedInstant instant = instant_in(arguments.from);
  game::GameSettings game = scenario_or_defaults(arguments, assignments);
  if (game.match.control != referee::Control::kAutoref)
    throw io::InputError({"--from"}, "",
                         "only AutoRef can command a game that begins with the state of a log; set "
                         "match.control=autoref");
  game::locate_errors("--from", [&] {
    logs::LoggedState logged = logs::logged_state(logs::seekable_log(instant.log), instant.at_s);
    if (arguments.file.empty()) take_defaults(logged, game);
    game::check_game(game);
    logs::check_same_field(logged, game.field);
    for (const Side side : kSides)
      logs::renumber(logged.start.robots[side], team_in(game, side).robots);
    keep_inside_walls(logged.start, game.field);
    game.start = logged.start;
  });
  return game;
}

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
  live::ControlledGame controlled(game, place, check_interrupt);
  GamePlayer player;
  player.play = [&](const game::Observers& observers, game::GamePrograms& programs) {
    return controlled.play(observers, programs);
  };
  game::GameRecord record = play_one(game, arguments.output, inputs, {arguments.commands}, player);
  print_outcome(controlled.report());
  return record;
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
  game::locate_errors(arguments.file.empty() ? "--from" : arguments.file, [&] {
    record = game.match.control == referee::Control::kGameController
                 ? play_controlled(game::resolved(game), arguments, inputs)
                 : play_one(game::resolved(game), arguments.output, inputs, {arguments.commands});
  });
  return record.status == game::Status::kVoid ? io::kTooManyVoid : io::kDone;
}

}  // namespace

void add_play_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("play", "Play one refereed game.");
  auto arguments = std::make_shared<PlayArguments>();
  add_scenario_argument(*verb, arguments->file, "Scenario of kind game; optional with --from.")
      ->required(false);
  verb->add_option(
          "--from", arguments->from,
          "Begin with the state of this SSL log at that time, in seconds from its start: robots, "
          "ball and pending restart come from the log; score and clock start at 0.")
      ->type_name("LOG@SECONDS");
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
      "  autoref play --from game.log.gz@83.2 --set match.rules=2026-b --view game.html");
  choose(*verb, chosen, arguments, play_verb);
}

}  // namespace autoref::app
