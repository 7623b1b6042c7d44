#include "game/loop/sensors.hpp"

#include "sim/dribbler_zone.hpp"

namespace autoref::game {

Sensors::Sensors(const GameConfiguration& configuration, Side side)
    : side_(side),
      robots_(team_on(configuration, side).robots),
      delayed_(sim::split_latency(configuration.sim).frames) {}

void Sensors::update(const Frame& frame, const sim::WorldState& world) {
  latest_.detections = side_ == Side::kWest ? frame : mirrored(frame);
  latest_.ball_in_dribbler_zone.reset();
  for (const sim::RobotState& robot : world.robots[side_]) {
    const auto number = static_cast<std::size_t>(robot.number);
    latest_.ball_in_dribbler_zone[number] = sim::is_in_dribbler_zone(
        robot, world.ball.position_m, world.ball.height_m, robots_[number].kicker.reach_m);
  }
  delayed_.push(latest_);
}

}  // namespace autoref::game
