// Messages as text: every value on one line, doubles in hexadecimal, so that equal texts mean equal
// bits. Structured bindings name all members, so that this fails to compile if a new member is
// missing.
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>

#include "league/team/team_messages.hpp"
#include "soccer/rules/rule_book.hpp"

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
    const auto& [number, position_m, heading, velocity_mps, turn_radps, is_seen] = robot;
    return add_each(number, position_m, heading, velocity_mps, turn_radps, is_seen);
  }
  Description& add(const TrackedBall& ball) {
    const auto& [position_m, velocity_mps, height_m, deviation_m, is_height_known] = ball;
    return add_each(position_m, velocity_mps, height_m, deviation_m, is_height_known);
  }
  Description& add(const RobotObservation& robot) {
    const auto& [number, position_m, heading] = robot;
    return add_each(number, position_m, heading);
  }
  Description& add(const BallObservation& ball) {
    const auto& [position_m, height_m, seen_from] = ball;
    return add_each(position_m, height_m, seen_from.position_m, seen_from.height_m);
  }
  Description& add(const Abilities& robot) {
    const auto& [speed_mps, acceleration_mps2, braking_mps2, kick_mps, chip_mps] = robot;
    return add_each(speed_mps, acceleration_mps2, braking_mps2, kick_mps, chip_mps);
  }
  Description& add(const RobotCommand& command) {
    const auto& [velocity_mps, turn_radps, kick_mps, chip, dribble] = command;
    return add_each(velocity_mps, turn_radps, kick_mps, chip, dribble);
  }
  Description& add(const TeamRequests& requests) {
    const auto& [keeper, leaves, timeout] = requests;
    return add_each(keeper, leaves, timeout);
  }
  Description& add(const Field& field) {
    const auto& [length, width, run_off, goal_line_run_off, substitution_area, line, circle, mark,
                 area, goal_width, depth, opening, bar, wall, sides_reach_wall] = field;
    const auto& [shape, area_depth, straight] = area;
    static_cast<void>(goal_line_run_off);  // 0 means the same as run_off
    static_cast<void>(substitution_area);  // is not sent
    return add_each(length, width, run_off, field.behind_goal_lines_m(), line, circle, mark, shape,
                    area_depth, straight, goal_width, depth, opening, bar, wall, sides_reach_wall);
  }
  template <typename Enum>
  requires std::is_enum_v<Enum> Description& add(Enum value) {
    return add(static_cast<int>(value));
  }
  template <typename... Values>
  Description& add_each(const Values&... values) {
    (add(values), ...);
    return *this;
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
  const auto& [side, field, rules, obeyed, frame_rate_hz, latency_s, random_seed, params, robots] =
      start;
  Description all;
  all.add_each(side, field, rules.name, frame_rate_hz, latency_s, fmt::format("{}", random_seed));
  visit_rule_numbers(rules, [&all](std::string_view name, double value) {
    all.add_each(std::string(name), value);
  });
  for (const RuleEntry& entry : rule_table()) all.add_each(obeyed.has(entry.rule));
  for (const auto& [name, value] : params) all.add_each(name, value);
  return all.add_all(robots).text;
}

// The view without the parts that detections replace.
inline std::string described(const TeamFrame& frame) {
  const auto& [number, time_s, latency_s, own, opponents, ball, play, ours, placement_m,
               placing_is_ours, next, next_is_ours, goals_own, goals_opponent, time_left_s] =
      frame.view;
  Description all;
  all.add_each(number, time_s, latency_s, play, ours, placement_m, placing_is_ours, next,
               next_is_ours, goals_own, goals_opponent, time_left_s);
  all.add(frame.ball_in_dribbler_zone.to_string());
  if (!frame.detections) return all.add(ball).add_all(own).add_all(opponents).text;
  all.add(frame.detections->ball);
  for (const Side side : kSides) all.add_all(frame.detections->robots[side]);
  return all.text;
}

inline std::string described(const TeamEnd& end) {
  return Description{}.add_each(end.reason, end.goals_own, end.goals_opponent).text;
}

inline std::string described(const TeamOutput& output) {
  const auto& [frame, commands, requests, text] = output;
  return Description{}.add_each(frame, requests, text).add_all(commands).text;
}

}  // namespace autoref::league
