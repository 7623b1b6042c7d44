// At a penalty kick, the keeper must touch its goal line between the posts, and all other robots
// except the kicker must be at least 400 mm behind the penalty mark (Laws 14) or 1 m behind the
// ball (2026, Penalty Kick). Positions are judged in the last frame before the ball is in play.
//
// Laws 2014: the kick proceeds, and its outcome decides whether it is retaken. After a breach by
// the kicker's side, the kick is retaken if there was a goal, which does not count. After a breach
// by the defenders' side, it is retaken if there was no goal. After breaches by both sides, it is
// retaken in either case. A kick is complete when it is a goal or a failure in the sense of
// penalty_outcome.hpp.
//
// 2026: there are no retakes. A breach counts as a foul, so it decides the kick as soon as the ball
// is in play (rule penalty_kick_failed), unless both sides are at fault.
//
// This is simpler than the rule books: the keeper's orientation, the kick's direction (Laws) and
// rebounds to offending robots are not judged.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "referee/geometry/hull.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/penalty_outcome.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// The robot of the kicker's side nearest to the ball.
std::optional<int> kicker_of(const SeenRobots& robots, const Vec2& ball_m) {
  const auto nearest = std::min_element(robots.begin(), robots.end(), [&](auto& a, auto& b) {
    return (a.position_m - ball_m).squaredNorm() < (b.position_m - ball_m).squaredNorm();
  });
  return nearest == robots.end() ? std::nullopt : std::optional(nearest->number);
}

// How far the whole hull is behind the ball, as seen from the goal of side `goal`.
double behind_ball_m(Side goal, const RobotObservation& robot, const Vec2& ball_m) {
  const Vec2 towards_goal(goal_sign(goal), 0);
  return (ball_m - robot.position_m).dot(towards_goal) -
         reach_of_hull_m(robot.heading, towards_goal);
}

// The robots of `side` that are too near, except robot `may_be`, which is allowed to be near.
PositionViolation too_near(Side side, std::optional<int> may_be, const RefereeState& state,
                           const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const Side goal = opponent_of(*state.play.kicker);
  const double least_m = c.rules.penalty_clearance_m - robot_to_ball_uncertainty_m(c.noise);
  PositionViolation found;
  for (const RobotObservation& robot : input.frame.robots[side]) {
    if (robot.number == may_be || !is_on_field(c.field, robot.position_m)) continue;
    const double behind_m = behind_ball_m(goal, robot, state.play.position_m);
    if (behind_m < least_m) found.add({side, robot.number}, behind_m, behind_m < found.worst_m);
  }
  return found;
}

// Distance of the keeper from the line between the posts; 0 or less if its hull touches that line.
double off_line_m(Side side, const RobotObservation& keeper, const Field& field) {
  const double depth_m = field.half_length_m() - goal_sign(side) * keeper.position_m.x();
  const bool in_front = depth_m > 0;
  const double reach_m =
      reach_of_hull_m(keeper.heading, Vec2(goal_sign(side) * (in_front ? 1 : -1), 0));
  // In front of the goal line, the line's width counts as touching it.
  const double line_m = in_front ? depth_m - field.line_width_m : -depth_m;
  const double beside_m = std::abs(keeper.position_m.y()) - field.half_goal_m();
  return std::max(line_m - reach_m, beside_m);
}

PositionViolation keeper_off_line(Side side, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  PositionViolation found;
  for (const RobotObservation& robot : input.frame.robots[side]) {
    if (robot.number != input.requests[side].keeper) continue;
    const double off_m = off_line_m(side, robot, c.field);
    if (off_m > robot_uncertainty_m(c.noise)) found.add({side, robot.number}, off_m, true);
  }
  return found;
}

void watch(PenaltyPositionsWatch& watch, const RefereeState& state, const RefereeInput& input) {
  const Side attacker = *state.play.kicker;
  const Side defender = opponent_of(attacker);
  watch.others[attacker] = too_near(
      attacker, kicker_of(input.frame.robots[attacker], input.ball->position_m), state, input);
  const int keeper = input.requests[defender].keeper;
  if (keeper < 0) return;  // the keeper is unknown, so it may be any of the defenders
  watch.others[defender] = too_near(defender, keeper, state, input);
  watch.keeper = keeper_off_line(defender, input);
}

std::string evidence_of(const PenaltyPositionsWatch& watch, const RuleBook& rules) {
  std::string text;
  for (Side side : kSides) {
    if (!watch.others[side].any()) continue;
    text += fmt::format("a {} robot was {} too far forward, ", colour_of(side),
                        mm_text(rules.penalty_clearance_m - watch.others[side].worst_m));
  }
  if (watch.keeper.any()) {
    text += fmt::format("the keeper {} was {} off its line, ", text_of(watch.keeper.robots.front()),
                        mm_text(watch.keeper.worst_m));
  }
  return "Just before the penalty kick " + text;
}

// A breach by `side`, or, if `both`, by each side.
Finding breach_of(const RefereeState& state, const RefereeInput& input, Side side, bool both) {
  const PenaltyPositionsWatch& watch = state.watch.penalty_positions;
  const RuleBook& rules = input.configuration.rules;
  Finding finding = finding_of(Event::kPenaltyPositions, RuleId::kPenaltyPositions, rules);
  const bool is_keepers = !watch.others[side].any();
  const PositionViolation& worst = is_keepers ? watch.keeper : watch.others[side];
  finding.value = worst.worst_m;
  if (is_keepers) finding.threshold = 0;  // the distance is measured from the keeper's goal line
  finding.robots.push_back(worst.robots.front());
  if (!both) finding.offender = side;
  finding.position_m = state.play.ball_from_m;
  finding.evidence = evidence_of(watch, rules);
  return finding;
}

PerSide<bool> sides_at_fault(const RefereeState& state) {
  const PenaltyPositionsWatch& watch = state.watch.penalty_positions;
  const Side defender = opponent_of(*state.play.kicker);
  PerSide<bool> sides;
  for (const Side side : kSides) {
    sides[side] = watch.others[side].any() || (side == defender && watch.keeper.any());
  }
  return sides;
}

// The rules of 2026.
std::optional<Finding> find_at_kick(const RefereeState& state, const RefereeInput& input) {
  const PerSide<bool> at_fault = sides_at_fault(state);
  const bool both = at_fault[Side::kWest] && at_fault[Side::kEast];
  const bool any = at_fault[Side::kWest] || at_fault[Side::kEast];
  if (!state.play.entered_now || !any) return std::nullopt;
  const Side attacker = *state.play.kicker;
  Finding finding =
      breach_of(state, input, at_fault[attacker] ? attacker : opponent_of(attacker), both);
  finding.evidence += "and the ball is in play.";
  return finding;
}

// The violations are kept until the outcome is known.
std::optional<Finding> check(RefereeState& state, const RefereeInput& input) {
  PenaltyPositionsWatch& watch = state.watch.penalty_positions;
  const bool is_goal = is_penalty_goal(state, input);
  if (watch.is_over || (!is_goal && !penalty_failure(state, input))) return std::nullopt;
  watch.is_over = true;
  const Side attacker = *state.play.kicker;
  const PerSide<bool> at_fault = sides_at_fault(state);
  const Side side = is_goal ? attacker : opponent_of(attacker);
  const bool both = at_fault[Side::kWest] && at_fault[Side::kEast];
  if (!(at_fault[side] || both) || !may_be_taken_again(state, input.configuration.rules))
    return std::nullopt;
  Finding finding = breach_of(state, input, side, both);
  take_again(finding, state.play);
  finding.evidence += fmt::format("and the outcome is {}.", is_goal ? "a goal" : "no goal");
  return finding;
}

std::optional<Finding> find_penalty_positions(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.is_penalty() || !play.kicker || !input.ball) return std::nullopt;
  const bool decides = input.configuration.rules.penalty_fouls_decide;
  if (play.in_play) return decides ? find_at_kick(state, input) : check(state, input);
  watch(state.watch.penalty_positions, state, input);
  return std::nullopt;
}

}  // namespace

constinit const Rule kPenaltyPositionsRule{{State::kRun}, find_penalty_positions};

}  // namespace autoref::referee
