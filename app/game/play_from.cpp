#include "app/game/play_from.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "game/settings/fields.hpp"
#include "game/settings/resolved.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "logs/log_game.hpp"
#include "logs/logged_state.hpp"
#include "logs/user_log.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::app {
namespace {

game::TeamSettings& team_in(game::GameSettings& game, Side side) {
  return side == game.match.a_plays ? game.a : game.b;
}

// What the user does not set is the log's.
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
    game::blame("--seed", [&] { game::set_by_path(game, "seed", arguments.seed); });
  return game;
}

}  // namespace

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

game::GameSettings game_from_log(const PlayArguments& arguments,
                                 const game::Assignments& assignments) {
  const PlayedInstant instant = instant_in(arguments.from);
  game::GameSettings game = scenario_or_defaults(arguments, assignments);
  if (game.match.control != referee::Control::kAutoref)
    throw io::InputError({"--from"}, "",
                         "only AutoRef can command such a game: match.control=autoref");
  game::blame("--from", [&] {
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

}  // namespace autoref::app
