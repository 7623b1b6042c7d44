#include "game/team_programs/world_change.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace autoref::game {
namespace {

struct Apply {
  Game& game;
  void operator()(const sim::BallState& ball) const { game.put_ball(ball); }
  void operator()(const RemovedRobot& removed) const { game.take_off(removed.robot); }
  void operator()(const PlacedRobot& placed) const {
    if (!game.world().is_on(placed.robot)) {
      if (!game.world().is_free(placed.state.position_m)) return;
      game.put_on(placed.robot, placed.state.position_m, placed.state.heading);
    }
    game.put_robot(placed.robot, placed.state);
  }
};

sim::RobotSpec& spec_in(RobotId robot, GameConfiguration& game) {
  TeamConfiguration& team = robot.side == game.match.a_plays ? game.a : game.b;
  const auto number = static_cast<std::size_t>(robot.number);
  if (robot.number < 0 || number >= team.robots.size())
    throw std::invalid_argument(fmt::format("the team has no robot {}", robot.number));
  return team.robots[number];
}

}  // namespace

void apply(const WorldChange& change, Game& game) { std::visit(Apply{game}, change); }

ChangedRobot unchanged(RobotId robot, const GameConfiguration& game) {
  const sim::RobotSpec& spec =
      team_on(game, robot.side).robots.at(static_cast<std::size_t>(robot.number));
  return {robot,
          spec.body.mass_kg,
          spec.body.speed_mps,
          spec.body.acceleration_mps2,
          spec.body.braking_mps2,
          spec.body.wheel_acceleration_mps2,
          spec.body.angular_speed_radps,
          spec.body.angular_acceleration_radps2,
          spec.kicker.speed_limit_mps,
          spec.kicker.chip_limit_mps};
}

void apply(const ChangedRobot& changed, GameConfiguration& game) {
  sim::RobotSpec& spec = spec_in(changed.robot, game);
  sim::RobotSpec next = spec;
  next.body.mass_kg = changed.mass_kg;
  next.body.speed_mps = changed.speed_mps;
  next.body.acceleration_mps2 = changed.acceleration_mps2;
  next.body.braking_mps2 = changed.braking_mps2;
  next.body.wheel_acceleration_mps2 = changed.wheel_acceleration_mps2;
  next.body.angular_speed_radps = changed.angular_speed_radps;
  next.body.angular_acceleration_radps2 = changed.angular_acceleration_radps2;
  next.kicker.speed_limit_mps = changed.kick_limit_mps;
  next.kicker.chip_limit_mps = changed.chip_limit_mps;
  sim::validate(next);
  spec = next;
}

}  // namespace autoref::game
