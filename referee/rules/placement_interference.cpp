#include "referee/rules/placement_interference.hpp"

#include <fmt/format.h>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct PlacementSegment {
  Vec2 ball_m{0, 0};
  Vec2 target_m{0, 0};
  Side kept_away = Side::kWest;  // who does not take the restart
};

// None while the ball is not on its way to a restart of one side.
std::optional<PlacementSegment> placement_segment(const RefereeState& state,
                                                  const RefereeInput& input) {
  const RefereeSignal& signal = state.signal;
  if (!input.tracks.ball || !signal.placement || !signal.next_command ||
      !is_for_one_side(signal.next_command->kind)) {
    return std::nullopt;
  }
  const Vec2& ball_m = input.tracks.ball->position_m;
  const Vec2& target_m = signal.placement->target_m;
  if ((target_m - ball_m).norm() <= input.configuration.rules.ball_in_position_m)
    return std::nullopt;
  return PlacementSegment{ball_m, target_m, opponent_of(signal.next_command->side)};
}

double gap_to_segment_m(const TrackedRobot& robot, const PlacementSegment& segment) {
  const Vec2 nearest_m = nearest_on_segment(robot.position_m, segment.ball_m, segment.target_m);
  return distance_to_hull(nearest_m, robot.position_m, robot.heading);
}

}  // namespace

std::optional<Finding> find_placement_interference(RefereeState& state, const RefereeInput& input) {
  if (!input.frame.ball) return std::nullopt;  // nobody knows where it is
  const Configuration& c = input.configuration;
  const std::optional<PlacementSegment> segment = placement_segment(state, input);
  const double limit_m = c.rules.placement_clearance_m;
  const auto excess_m = [&](Side side, const TrackedRobot& robot) {
    return segment && side == segment->kept_away ? limit_m - gap_to_segment_m(robot, *segment)
                                                 : 0.0;
  };
  const std::optional<GraceViolation> nearest =
      take_worst(state.watch.placement_interference, input, c.rules.placement_grace_s, excess_m);
  if (!nearest) return std::nullopt;
  Finding finding = note_of(Event::kPlacementInterference, RuleId::kPlacementInterference, c.rules,
                            nearest->id, nearest->position_m);
  finding.value = limit_m - nearest->excess;
  finding.evidence = fmt::format(
      "{} is {:.0f} mm from the line between the ball and its position, after {:.1f} s near it.",
      text_of(nearest->id), 1e3 * finding.value, c.rules.placement_grace_s);
  return finding;
}

}  // namespace autoref::referee
