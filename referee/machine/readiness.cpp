#include "referee/machine/readiness.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// The ball is set to its position this long before the timeout, so that it is there when play
// continues.
constexpr double kSetBallBefore_s = 500_ms;

bool is_look_due(const RefereeState& state, const RefereeInput& input) {
  return has_passed(state.checked_s, input.configuration.rules.readiness_period_s, input.time_s());
}

// Deviation D13: the ball must also be at rest at its designated position.
//
// The ball counts as at rest once it has stayed within the tolerance for as long as a ball at the
// resting speed would need to cross the tolerance. Noise in single frames does not matter.
double rest_time_s(const RuleBook& rules) {
  return 2 * rules.ball_in_position_m / rules.ball_at_rest_mps;
}

bool rests_in_position(const RefereeState& state, const RefereeInput& input) {
  return state.ball_in_position_since_s &&
         has_passed(*state.ball_in_position_since_s, rest_time_s(input.configuration.rules),
                    input.time_s());
}

Finding moves_finding(Event event, std::string_view rule, const RefereeInput& input,
                      double value_m) {
  Finding finding;
  finding.event = event;
  finding.rule = rule;
  finding.value = value_m;
  finding.threshold = input.configuration.rules.stillness_m;
  finding.unit = "m";
  if (input.ball) finding.position_m = input.ball->position_m;
  return finding;
}

Finding timeout_finding(Event event, std::string_view rule, double waited_s, double limit_s) {
  Finding finding;
  finding.event = event;
  finding.rule = rule;
  finding.value = waited_s;
  finding.threshold = limit_s;
  finding.unit = "s";
  return finding;
}

// Deviation D5: one moving robot per team is enough, as section 4.4 says; section 4.3 says "all
// robots".
bool is_more_on_both_sides(const LargestMoves& moves, double limit_m) {
  return std::all_of(kSides.begin(), kSides.end(),
                     [&](Side side) { return moves.robot[side] && moves.move_m[side] > limit_m; });
}

double largest_move_m(const LargestMoves& moves) {
  return std::max(moves.move_m[Side::kWest], moves.move_m[Side::kEast]);
}

Finding robots_moved(const LargestMoves& moves, const RefereeInput& input) {
  const double least_m = std::min(moves.move_m[Side::kWest], moves.move_m[Side::kEast]);
  Finding finding = moves_finding(Event::kRobotsMoved, "paper 4.4, WAIT_START", input, least_m);
  for (Side side : kSides) finding.robots.push_back(*moves.robot[side]);
  finding.evidence =
      fmt::format("On each team a robot has moved {:.1f} mm or more.", 1e3 * least_m);
  return finding;
}

Finding ready(double most_m, const RefereeState& state, const RefereeInput& input) {
  Finding finding = moves_finding(Event::kReady, "paper 4.4, WAIT_STOP", input, most_m);
  finding.evidence = fmt::format(
      "Within {:.2f} s no robot has moved more than {:.1f} mm, and the ball rests at its position.",
      input.time_s() - state.saved.time_s, 1e3 * most_m);
  return finding;
}

Finding ready_timeout(const RefereeState& state, const RefereeInput& input) {
  const LargestMoves moves = largest_moves(state.saved, input.frame);
  const RuleBook& rules = input.configuration.rules;
  Finding finding = timeout_finding(Event::kReadyTimeout, "paper 4.2, a fixed timeout",
                                    input.time_s() - state.wait_began_s, rules.ready_timeout_s);
  for (Side side : kSides) {
    if (moves.robot[side] && moves.move_m[side] >= rules.stillness_m) {
      finding.robots.push_back(*moves.robot[side]);
    }
  }
  if (input.ball) finding.position_m = input.ball->position_m;
  finding.evidence = fmt::format(
      "The wait timed out after {:.2f} s: since the last check robots have moved up to {:.1f} mm, "
      "and the ball {} at its position.",
      finding.value, 1e3 * largest_move_m(moves),
      rests_in_position(state, input) ? "rests" : "did not rest");
  return finding;
}

}  // namespace

SavedPositions positions_in(const Frame& frame) { return {frame.robots, frame.time_s}; }

LargestMoves largest_moves(const SavedPositions& saved, const Frame& frame) {
  LargestMoves moves;
  for (Side side : kSides) {
    for (const RobotObservation& robot : frame.robots[side]) {
      const RobotObservation* before = find_robot(saved.robots[side], robot.number);
      if (before == nullptr) continue;
      // Deviation D6: in the formula of this distance, the paper prints r_y instead of r_x.
      const double move_m = (robot.position_m - before->position_m).norm();
      if (moves.robot[side] && !(move_m > moves.move_m[side])) continue;
      moves.move_m[side] = move_m;
      moves.robot[side] = RobotId{side, robot.number};
    }
  }
  return moves;
}

double ball_tolerance_m(const Configuration& configuration) {
  return configuration.rules.ball_in_position_m + 2 * configuration.camera_error_m;
}

void watch_ball(RefereeState& state, const RefereeInput& input) {
  const bool in_position = input.ball && state.signal.placement &&
                           (input.ball->position_m - state.signal.placement->target_m).norm() <=
                               ball_tolerance_m(input.configuration);
  if (!in_position) {
    state.ball_in_position_since_s.reset();
  } else if (!state.ball_in_position_since_s) {
    state.ball_in_position_since_s = input.time_s();
  }
}

std::optional<Finding> find_start(RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  if (is_look_due(state, input)) {
    state.checked_s = input.time_s();
    const LargestMoves moves = largest_moves(state.saved, input.frame);
    if (is_more_on_both_sides(moves, rules.stillness_m)) return robots_moved(moves, input);
  }
  if (!has_passed(state.wait_began_s, rules.start_timeout_s, input.time_s())) {
    return std::nullopt;
  }
  // Deviation D2: a team that never moves must not hang a batch of games.
  Finding finding = timeout_finding(Event::kStartTimeout, "AutoRef",
                                    input.time_s() - state.wait_began_s, rules.start_timeout_s);
  finding.evidence =
      fmt::format("No robot of at least one team has moved for {:.2f} s.", finding.value);
  return finding;
}

std::optional<Finding> find_ready(RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  const double now_s = input.time_s();
  watch_ball(state, input);
  const bool is_late = has_passed(state.wait_began_s, rules.ready_timeout_s, now_s);
  if (is_look_due(state, input)) {
    const double most_m = largest_move_m(largest_moves(state.saved, input.frame));
    if (most_m < rules.stillness_m && rests_in_position(state, input)) {
      return ready(most_m, state, input);
    }
    // Keeps the saved positions for the timeout's evidence.
    if (!is_late) state.saved = positions_in(input.frame);
    state.checked_s = now_s;
  }
  if (state.signal.placement &&
      has_passed(state.wait_began_s, rules.ready_timeout_s - kSetBallBefore_s, now_s)) {
    state.signal.placement->at_once = true;
  }
  if (!is_late) return std::nullopt;
  return ready_timeout(state, input);
}

}  // namespace autoref::referee
