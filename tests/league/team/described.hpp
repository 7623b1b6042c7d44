// Messages as text: every value on one line, doubles in hexadecimal, so that equal texts mean equal
// bits.
#pragma once

#include <fmt/format.h>

#include <string>

#include "league/team/rule_numbers.hpp"
#include "league/team/team_messages.hpp"

namespace autoref::league {

class Description {
 public:
  Description& add(double value) { return line(fmt::format("{:a}", value)); }
  Description& add(const Vec2& v) { return add(v.x()).add(v.y()); }
  Description& add(std::int64_t value) { return line(fmt::format("{}", value)); }
  Description& add(int value) { return add(static_cast<std::int64_t>(value)); }
  Description& add(bool value) { return line(value ? "yes" : "no"); }
  Description& add(const std::string& words) { return line(words); }
  template <typename Value>
  Description& add(const std::optional<Value>& value) {
    return value ? add(*value) : line("none");
  }
  Description& add(const TrackedRobot& robot) {
    return add(robot.number)
        .add(robot.position_m)
        .add(robot.heading)
        .add(robot.velocity_mps)
        .add(robot.angular_velocity_radps)
        .add(robot.is_seen);
  }
  Description& add(const RobotObservation& robot) {
    return add(robot.number).add(robot.position_m).add(robot.heading);
  }
  Description& add(const BallObservation& ball) {
    return add(ball.position_m)
        .add(ball.height_m)
        .add(ball.seen_from.position_m)
        .add(ball.seen_from.height_m);
  }
  template <typename Robots>
  Description& add_all(const Robots& robots) {
    line("robots");
    for (const auto& robot : robots) add(robot);
    return *this;
  }

  std::string text;

 private:
  Description& line(const std::string& value) {
    text += value + "\n";
    return *this;
  }
};

inline std::string described(const TeamStart& start) {
  Description all;
  all.add(static_cast<int>(start.side)).add(fmt::format("{}", start.random_seed));
  all.add(start.frame_rate_hz).add(start.latency_s).add(start.rules.name);
  visit_rule_numbers(start.rules, [&all](std::string_view name, double value) {
    all.add(std::string(name)).add(value);
  });
  for (const auto& [name, value] : start.params) all.add(name).add(value);
  for (const Abilities& robot : start.robots) {
    all.add(robot.speed_mps)
        .add(robot.acceleration_mps2)
        .add(robot.braking_mps2)
        .add(robot.kick_mps)
        .add(robot.chip_mps);
  }
  const Field& field = start.field;
  all.add(static_cast<int>(field.defence_area.shape));
  for (const double length_m :
       {field.length_m, field.width_m, field.run_off_m, field.line_width_m,
        field.centre_circle_radius_m, field.penalty_mark_m, field.defence_area.depth_m,
        field.defence_area.straight_m, field.goal_width_m, field.goal_depth_m,
        field.goal_opening_height_m, field.goal_bar_radius_m, field.goal_wall_thickness_m}) {
    all.add(length_m);
  }
  return all.text;
}

// Without the parts of the view that detections replace.
inline std::string described(const TeamFrame& frame) {
  Description all;
  const TeamView& view = frame.view;
  all.add(view.frame).add(view.time_s).add(view.latency_s).add(static_cast<int>(view.play));
  all.add(view.ours).add(view.placement_m).add(view.placing_is_ours);
  all.add(view.next ? std::optional(static_cast<int>(*view.next)) : std::nullopt);
  all.add(view.next_is_ours).add(view.goals_own).add(view.goals_opponent);
  all.add(view.stage_time_left_s).add(frame.ball_in_dribbler_zone.to_string());
  if (frame.detections) {
    all.add(frame.detections->ball);
    for (const Side side : kSides) all.add_all(frame.detections->robots[side]);
    return all.text;
  }
  const TrackedBall& ball = view.ball;
  all.add(ball.position_m)
      .add(ball.velocity_mps)
      .add(ball.height_m)
      .add(ball.height_deviation_m)
      .add(ball.is_height_known);
  return all.add_all(view.own).add_all(view.opponents).text;
}

inline std::string described(const TeamEnd& end) {
  return Description{}.add(end.reason).add(end.goals_own).add(end.goals_opponent).text;
}

inline std::string described(const TeamOutput& output) {
  Description all;
  all.add(output.frame).add(output.requests.keeper).add(output.requests.leaves);
  all.add(output.requests.timeout).add(output.text);
  for (const RobotCommand& command : output.commands) {
    all.add(command.velocity_mps)
        .add(command.angular_velocity_radps)
        .add(command.kick_mps)
        .add(command.chip)
        .add(command.dribble);
  }
  return all.text;
}

}  // namespace autoref::league
