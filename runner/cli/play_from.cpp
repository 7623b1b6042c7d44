#include "runner/cli/play_from.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "runner/logs/log_game.hpp"
#include "runner/logs/logged_state.hpp"
#include "runner/logs/user_log.hpp"
#include "runner/settings/fields.hpp"
#include "runner/settings/resolved.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::runner {
namespace {

TeamSettings& team_in(GameSettings& game, Side side) {
  return side == game.match.a_plays ? game.a : game.b;
}

// What the user does not set is the log's.
void take_defaults(const LoggedState& logged, GameSettings& game) {
  const auto is_given = [&game](std::string_view path) {
    return std::any_of(game.given.begin(), game.given.end(),
                       [path](const std::string& one) { return one.starts_with(path); });
  };
  if (!is_given("field.")) game.field = field_in(logged.log, game.field);
  for (const Side side : kSides) {
    if (is_given(side == game.match.a_plays ? "teams.a.robots" : "teams.b.robots")) continue;
    const StartingRobots& robots = logged.start.robots[side];
    team_in(game, side).robots = std::max(1, static_cast<int>(robots.size()));
  }
}

void keep_inside_walls(StartState& start, const Field& field) {
  const auto clamped = [&field](const Vec2& position_m, double radius_m) {
    const double x_m = field.wall_x_m() - radius_m;
    const double y_m = field.wall_y_m() - radius_m;
    return Vec2(std::clamp(position_m.x(), -x_m, x_m), std::clamp(position_m.y(), -y_m, y_m));
  };
  for (StartingRobots& robots : start.robots.values) {
    for (sim::RobotState& robot : robots)
      robot.position_m = clamped(robot.position_m, kRobotRadius_m);
  }
  start.ball.position_m = clamped(start.ball.position_m, kBallRadius_m);
}

GameSettings scenario_or_defaults(const PlayArguments& arguments, const Assignments& assignments) {
  if (!arguments.file.empty()) return game_in(arguments.file, arguments.seed, assignments);
  GameSettings game;
  assign_all(assignments, game);
  if (!arguments.seed.empty()) blame("--seed", [&] { set_by_path(game, "seed", arguments.seed); });
  return game;
}

}  // namespace

PlayedInstant instant_in(const std::string& from) {
  const std::size_t at = from.rfind('@');
  const std::optional<double> seconds =
      at == std::string::npos ? std::nullopt : number_in(from.substr(at + 1));
  if (!seconds || at == 0) {
    throw InputError(
        {"--from"}, "",
        fmt::format("expected LOG@SECONDS, such as game.log.gz@83.2, found '{}'", from));
  }
  return {from.substr(0, at), *seconds};
}

GameSettings game_from_log(const PlayArguments& arguments, const Assignments& assignments) {
  const PlayedInstant instant = instant_in(arguments.from);
  GameSettings game = scenario_or_defaults(arguments, assignments);
  if (game.match.control != referee::Control::kAutoref)
    throw InputError({"--from"}, "", "only AutoRef can command such a game: match.control=autoref");
  blame("--from", [&] {
    LoggedState logged = logged_state(seekable_log(instant.log), instant.at_s);
    if (arguments.file.empty()) take_defaults(logged, game);
    check_game(game);
    check_same_field(logged, game.field);
    for (const Side side : kSides) renumber(logged.start.robots[side], team_in(game, side).robots);
    keep_inside_walls(logged.start, game.field);
    game.start = logged.start;
  });
  return game;
}

}  // namespace autoref::runner
