// Messages with random content.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "league/team/team_messages.hpp"
#include "soccer/random.hpp"

namespace autoref::league {

// Draws values of every kind, including -0 and doubles with 17 digits or of extreme size.
class RandomMessages {
 public:
  explicit RandomMessages(std::uint64_t seed) : random_(seed) {}

  TeamStart start() {
    TeamStart start;
    start.side = one_in(2) ? Side::kEast : Side::kWest;
    start.rules = *find_rule_book(one_in(2) ? "2026-a" : "2014");
    start.rules.kick_limit_mps = number();
    start.obeyed[RuleId::kBotDribbledBallTooFar] = one_in(2);
    start.frame_rate_hz = number();
    start.latency_s = number();
    start.random_seed = random_();
    start.params = {{"line_m", number()}, {"a \"name\"", number()}, {std::string(55, 'x'), -0.0}};
    for (double* member :
         {&start.field.length_m, &start.field.width_m, &start.field.run_off_m,
          &start.field.goal_line_run_off_m, &start.field.line_width_m,
          &start.field.centre_circle_radius_m, &start.field.penalty_mark_m,
          &start.field.defence_area.depth_m, &start.field.defence_area.straight_m,
          &start.field.goal_width_m, &start.field.goal_depth_m, &start.field.goal_opening_height_m,
          &start.field.goal_bar_radius_m, &start.field.goal_wall_thickness_m}) {
      *member = number();
    }
    if (one_in(2)) start.field.defence_area.shape = DefenceArea::Shape::kBox;
    start.field.goal_sides_reach_wall = one_in(2);
    start.robots.resize(random_() % (kMaxRobots + 1));
    for (Abilities& robot : start.robots)
      robot = {number(), number(), number(), number(), number()};
    return start;
  }

  TeamFrame frame() {
    TeamFrame frame;
    TeamView& view = frame.view;
    view.frame = static_cast<std::int64_t>(random_() >> 2U);
    view.time_s = number();
    view.latency_s = number();
    view.own = tracked_robots();
    view.opponents = tracked_robots();
    view.ball = {vector(), vector(), number(), number(), one_in(2)};
    view.play = static_cast<Play>(random_() % 9);
    view.ours = one_in(2);
    if (one_in(2)) view.placement_m = vector();
    if (one_in(2)) view.placing_is_ours = one_in(2);
    if (one_in(2)) view.next = static_cast<CommandKind>(random_() % 11);
    view.next_is_ours = one_in(2);
    view.goals_own = small();
    view.goals_opponent = small();
    view.stage_time_left_s = number();
    frame.ball_in_dribbler_zone = random_() & 0xFFFFU;
    return frame;
  }

  TeamFrame frame_with_detections() {
    TeamFrame frame = this->frame();
    Frame& seen = frame.detections.emplace();
    seen.number = frame.view.frame;
    seen.time_s = frame.view.time_s;
    for (const Side side : kSides) {
      seen.robots[side].resize(random_() % (kMaxRobots + 1));
      for (RobotObservation& robot : seen.robots[side])
        robot = {robot_number(), vector(), vector()};
    }
    if (one_in(3)) return frame;
    seen.ball.emplace();
    seen.ball->position_m = vector();
    if (one_in(2)) seen.ball->height_m = number();
    seen.ball->seen_from = {vector(), number()};
    return frame;
  }

  TeamEnd end() { return {"time", small(), small()}; }

  TeamOutput output() {
    TeamOutput output;
    output.frame = static_cast<std::int64_t>(random_() >> 2U);
    for (RobotCommand& command : output.commands) {
      command.velocity_mps = {speed(), speed()};
      command.angular_velocity_radps = speed();
      command.kick_mps = random_.uniform() * 10;
      command.chip = one_in(2);
      command.dribble = one_in(2);
    }
    output.requests.keeper = static_cast<int>(random_() % 17) - 1;
    if (one_in(2)) output.requests.leaves = robot_number();
    output.requests.timeout = one_in(2);
    output.text = "pass to 3";
    return output;
  }

 private:
  bool one_in(std::uint64_t n) { return random_() % n == 0; }
  int small() { return static_cast<int>(random_() % 100); }
  int robot_number() { return static_cast<int>(random_() % kMaxRobots); }
  double speed() { return one_in(8) ? -0.0 : 6 * random_.uniform() - 3; }
  double number() {
    constexpr std::array kSpecial = {0.0, -0.0, 3.0, -1e300, 5e-324, 0.1, 1e22, 1e-7};
    return one_in(4) ? kSpecial[random_() % kSpecial.size()] : 20 * random_.uniform() - 10;
  }
  Vec2 vector() {
    const double x = number();
    return {x, number()};
  }
  TrackedRobots tracked_robots() {
    TrackedRobots robots(random_() % (kMaxRobots + 1));
    for (TrackedRobot& robot : robots)
      robot = {robot_number(), vector(), vector(), vector(), number(), one_in(2)};
    return robots;
  }

  RandomStream random_;
};

}  // namespace autoref::league
