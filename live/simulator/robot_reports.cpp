#include "live/simulator/robot_reports.hpp"

#include "sim/kicker.hpp"
#include "soccer/units.hpp"

namespace autoref::live {

PerSide<RobotReports> reports_of(const game::GameConfiguration& game, const sim::World& world) {
  PerSide<RobotReports> reports;
  const sim::WorldState& state = world.state();
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : state.robots[side]) {
      const auto number = static_cast<std::size_t>(robot.number);
      const double reach_m = game::team_on(game, side).robots[number].kicker.reach_m;
      const bool has_contact =
          sim::is_in_dribbler_zone(robot, state.ball.position_m, state.ball.height_m, reach_m);
      reports[side].ball_contact[number] = has_contact;
      reports[side].status.at(number).infrared = has_contact;
    }
  }
  for (const sim::Touch& touch : world.touches()) {
    if (!touch.is_kick) continue;
    league::GrsimStatus& status =
        reports[touch.robot.side].status.at(static_cast<std::size_t>(touch.robot.number));
    (touch.vertical_mps > 0 ? status.chip_kick : status.flat_kick) = true;
  }
  return reports;
}

std::array<league::WheelPositions, kMaxRobots> wheels_of(const game::TeamConfiguration& team) {
  std::array<league::WheelPositions, kMaxRobots> wheels{};
  for (std::size_t number = 0; number < team.robots.size(); ++number) {
    const sim::RobotParameters& body = team.robots[number].body;
    const double front_rad = to_radians(body.front_wheels_deg);
    const double back_rad = to_radians(body.back_wheels_deg);
    wheels.at(number) = {{-front_rad, -back_rad, back_rad, front_rad}, body.wheel_distance_m};
  }
  return wheels;
}

void headings_of(const sim::WorldState& world, Side side, bool blue_on_positive_half,
                 SideState& state) {
  for (const sim::RobotState& robot : world.robots[side]) {
    state.headings.at(static_cast<std::size_t>(robot.number)) =
        blue_on_positive_half ? robot.heading : Vec2(-robot.heading);
  }
}

}  // namespace autoref::live
