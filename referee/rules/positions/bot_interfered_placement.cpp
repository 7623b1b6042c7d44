// During ball placement, robots of the side that does not take the restart keep 0.5 m away from the
// line between the ball and its target, after a grace period of 2 s (2026). Only one foul per
// placement counts; it extends the placement by 10 s. While a team places the ball, further robots
// also extend the placement, but are not counted.
//
// No team can interfere before penalty kicks or kick-offs, and therefore after goals. The reason is
// that the foul is committed by "the non-placing team", and "the referee has to place the ball for
// all kickoffs and all penalty kicks" (Rules of the RoboCup Small Size League, Ball Placement,
// Usage).
#include <fmt/format.h>

#include "referee/machine/ball_placement.hpp"
#include "referee/machine/readiness.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct PlacementSegment {
  Vec2 ball_m{0, 0};
  Vec2 target_m{0, 0};
  Side kept_away = Side::kWest;  // the side that does not take the restart
};

// The side whose robots place the ball, or, if the simulator places it instead, the side that takes
// the free kick.
std::optional<Side> placing_side(const RefereeState& state) {
  if (state.machine_state == State::kPlacement) return state.placing.side;
  const std::optional<Command>& next = state.signal.next_command;
  if (is_placement_due(state) || !next) return std::nullopt;
  if (!is_placed_by_team(next->kind) || !is_for_one_side(next->kind)) return std::nullopt;
  return next->side;
}

// The current placement; nullopt unless the ball is being placed for one side's free kick.
std::optional<PlacementSegment> placement_segment(const RefereeState& state,
                                                  const RefereeInput& input) {
  const RefereeSignal& signal = state.signal;
  const std::optional<Side> placer = placing_side(state);
  if (!input.tracks.ball || !signal.placement || !placer) return std::nullopt;
  const Vec2& ball_m = input.tracks.ball->position_m;
  const Vec2& target_m = signal.placement->target_m;
  if ((target_m - ball_m).norm() <= ball_tolerance_m(input.configuration)) return std::nullopt;
  return PlacementSegment{ball_m, target_m, opponent_of(*placer)};
}

double gap_to_segment_m(const TrackedRobot& robot, const PlacementSegment& direction) {
  const Vec2 nearest_m = nearest_on_segment(robot.position_m, direction.ball_m, direction.target_m);
  return distance_to_hull(nearest_m, robot.position_m, robot.heading);
}

std::optional<Finding> find_bot_interfered_placement(RefereeState& state,
                                                     const RefereeInput& input) {
  if (!input.frame.ball) return std::nullopt;  // the ball's position is unknown
  const bool is_counted = state.watch.interference_is_called;
  if (is_counted && state.machine_state != State::kPlacement) return std::nullopt;
  const Configuration& c = input.configuration;
  const std::optional<PlacementSegment> direction = placement_segment(state, input);
  const double limit_m = c.rules.placement_clearance_m;
  const auto excess_m = [&](Side side, const TrackedRobot& robot) {
    return direction && side == direction->kept_away ? limit_m - gap_to_segment_m(robot, *direction)
                                                     : 0.0;
  };
  const std::optional<GraceViolation> nearest =
      take_worst(state.watch.bot_interfered_placement, input, c.rules.placement_grace_s, excess_m);
  if (!nearest) return std::nullopt;
  state.watch.interference_is_called = true;
  Finding finding = note_of(Event::kBotInterferedPlacement, RuleId::kBotInterferedPlacement,
                            c.rules, nearest->id, nearest->position_m);
  if (is_counted) finding.is_foul = false;
  finding.value = limit_m - nearest->excess;
  finding.evidence = fmt::format(
      "{} is still {} from the line between the ball and its target position after {:.1f} s.",
      text_of(nearest->id), mm_text(finding.value), c.rules.placement_grace_s);
  return finding;
}

}  // namespace

constinit const Rule kBotInterferedPlacementRule{{State::kWaitStop, State::kPlacement},
                                                 find_bot_interfered_placement};

}  // namespace autoref::referee
