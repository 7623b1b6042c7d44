// At a kick-off, every robot must be in its own half, except that the kicker may cross the halfway
// line inside the centre circle (Laws 8; 2026, Kick-Off). Otherwise the kick-off is retaken.
//
// Positions are judged in the last frame before the ball is in play. A robot is out of position
// if its whole hull is beyond the halfway line. The kicker is the robot of the kicking side nearest
// to the centre, if it is inside the circle. Robots outside the field do not count.
#include <fmt/format.h>
#include <algorithm>

#include "referee/geometry/hull.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// How far the hull's rearmost point is beyond the halfway line.
double beyond_middle_m(Side side, const RobotObservation& robot) {
  const Vec2 home(goal_sign(side), 0);
  return -(robot.position_m.dot(home) + reach_of_hull_m(robot.heading, home));
}

// The number of the kicker, which may be beyond the halfway line.
std::optional<int> kicker_in_circle(const SeenRobots& robots, const Field& field) {
  std::optional<int> kicker;
  double nearest_m = field.centre_circle_radius_m;
  for (const RobotObservation& robot : robots) {
    if (robot.position_m.norm() > nearest_m) continue;
    nearest_m = robot.position_m.norm();
    kicker = robot.number;
  }
  return kicker;
}

PositionViolation violation(Side side, const RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const SeenRobots& robots = input.frame.robots[side];
  const std::optional<int> kicker =
      side == state.play.kicker ? kicker_in_circle(robots, c.field) : std::nullopt;
  PositionViolation found;
  for (const RobotObservation& robot : robots) {
    const double beyond_m = beyond_middle_m(side, robot);
    if (robot.number == kicker || !is_on_field(c.field, robot.position_m)) continue;
    if (beyond_m > robot_uncertainty_m(c.noise)) {
      found.add({side, robot.number}, beyond_m, beyond_m > found.worst_m);
    }
  }
  return found;
}

Finding taken_again(const PerSide<PositionViolation>& before, const RefereeState& state,
                    const RefereeInput& input) {
  Finding finding =
      finding_of(Event::kKickoffPositions, RuleId::kKickoffPositions, input.configuration.rules);
  finding.unit = "m";
  for (Side side : kSides) {
    finding.value = std::max(finding.value, before[side].worst_m);
    if (!before[side].any()) continue;
    finding.robots.push_back(before[side].robots.front());
    if (!before[opponent_of(side)].any()) finding.offender = side;
  }
  finding.position_m = state.play.ball_from_m;
  take_again(finding, state.play);
  finding.evidence = fmt::format(
      "Just before the kick-off {} was entirely in the opponents' half, up to {:.0f} mm beyond the "
      "halfway line.",
      text_of(finding.robots.front()), 1e3 * finding.value);
  return finding;
}

std::optional<Finding> find_kickoff_positions(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.is_kickoff() || !play.kicker) return std::nullopt;
  PerSide<PositionViolation>& before = state.watch.kickoff_positions.before;
  if (!play.in_play) {
    for (Side side : kSides) before[side] = violation(side, state, input);
    return std::nullopt;
  }
  const bool any = before[Side::kWest].any() || before[Side::kEast].any();
  if (!play.entered_now || !any || !may_be_taken_again(state, input.configuration.rules))
    return std::nullopt;
  return taken_again(before, state, input);
}

}  // namespace

constinit const Rule kKickoffPositionsRule{{State::kRun}, find_kickoff_positions};

}  // namespace autoref::referee
