// "When the ball leaves the field without entering a goal, a free kick is awarded to the team which
// touched the ball less recently" (paper, section 4.2): throw-in, corner kick or goal kick.
//
// Deviation D14: if the last touch is unknown, a ball that crossed a goal line leads to a goal kick
// (the paper's "otherwise"), and a ball that crossed a touch line leads to a force start from the
// throw-in position. Other rule books have no "otherwise". Under those, a ball that crossed a goal
// line leads to a force start from a neutral position, so that an unseen touch favours neither
// side.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "referee/geometry/ball_out.hpp"
#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct Award {
  Event event = Event::kThrowIn;
  Side kicker = Side::kWest;  // west if neither side is the offender
  Vec2 position_m{0, 0};
};

Award over_touch_line(const RefereeInput& input, const Vec2& exit_m) {
  const Configuration& c = input.configuration;
  const Vec2 position_m = throw_in_position(c.field, c.rules, exit_m);
  if (!input.last_touch.side) {
    return {Event::kTouchLineUnknown, Side::kWest, position_m};
  }
  return {Event::kThrowIn, opponent_of(*input.last_touch.side), position_m};
}

Award over_goal_line(const RefereeInput& input, const Vec2& exit_m) {
  const Configuration& c = input.configuration;
  const Side defender = exit_m.x() < 0 ? Side::kWest : Side::kEast;
  const Side attacker = opponent_of(defender);
  if (input.last_touch.side == defender) {
    return {Event::kCornerKick, attacker, corner_kick_position(c.field, c.rules, attacker, exit_m)};
  }
  if (!input.last_touch.side && c.rules.edition != Edition::kPaper) {
    return {Event::kGoalLineUnknown, Side::kWest, neutral_position(c.field, c.rules, exit_m)};
  }
  return {Event::kGoalKick, defender, goal_kick_position(c.field, c.rules, defender, exit_m)};
}

std::string touched_by(const LastTouch& touch) {
  if (!touch.side) return "the last touch is unknown";
  if (!touch.robot) return fmt::format("{} touched it last", colour_of(*touch.side));
  return fmt::format("{} touched it last, at {:.3f} s", text_of(*touch.robot), touch.time_s);
}

// The text does not mention coordinates, since teams change ends (soccer/referee_signal.hpp).
std::string crossing_text(const Exit& exit) {
  const std::string_view half = colour_of(exit.point_m.x() < 0 ? Side::kWest : Side::kEast);
  if (exit.line == ExitLine::kTouch) {
    return fmt::format("a touch line in {}'s half, {:.3f} m from the halfway line", half,
                       std::abs(exit.point_m.x()));
  }
  return fmt::format("{}'s goal line, {:.3f} m from its middle", half, std::abs(exit.point_m.y()));
}

std::optional<Finding> find_ball_leaves_field(RefereeState& /*state*/, const RefereeInput& input) {
  const Field& field = input.configuration.field;
  if (!input.ball || !is_out_of_field(field, input.ball->position_m)) return std::nullopt;
  const Vec2& ball_m = input.ball->position_m;
  const Exit exit = find_exit(field, input.ball->before_m, ball_m);
  const bool touch_line = exit.line == ExitLine::kTouch;
  const Award award =
      touch_line ? over_touch_line(input, exit.point_m) : over_goal_line(input, exit.point_m);
  Finding finding = finding_of(award.event, RuleId::kBallLeavesField, input.configuration.rules);
  finding.value = std::abs(touch_line ? ball_m.y() : ball_m.x());
  finding.threshold = (touch_line ? field.half_width_m() : field.half_length_m()) + kBallRadius_m;
  finding.unit = "m";
  if (input.last_touch.robot) finding.robots.push_back(*input.last_touch.robot);
  finding.position_m = exit.point_m;
  if (award.event == Event::kThrowIn) {
    finding.restart = indirect_free_kick(input.configuration.rules, award.kicker);
  }
  finding.restart.side = award.kicker;
  finding.ball_to_m = award.position_m;
  finding.evidence =
      fmt::format("The ball crossed {}; {}.", crossing_text(exit), touched_by(input.last_touch));
  return finding;
}

}  // namespace

constinit const Rule kBallLeavesFieldRule{{State::kRun}, find_ball_leaves_field};

}  // namespace autoref::referee
