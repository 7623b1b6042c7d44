#include "referee/machine/readiness.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// The ball is set to its place this long before the wait is over, so that it lies there when play
// goes on: three frames of a 60 Hz camera.
constexpr double kSetBallBefore_s = 500_ms;

bool is_look_due(const Memory& memory, const Moment& moment) {
  return has_passed(memory.looked_s, moment.configuration.rules.look_period_s, moment.time_s());
}

// Deviation D13: the ball must rest at its place, too.
//
// A ball that stays within the tolerance for as long as it takes to cross it at the speed of a
// resting ball is at rest, however noisy the single pictures are.
double rest_time_s(const RuleBook& rules) {
  return 2 * rules.ball_in_place_m / rules.ball_at_rest_mps;
}

void watch_ball(Memory& memory, const Moment& moment) {
  const bool in_place = moment.ball && memory.signal.placement &&
                        (moment.ball->position_m - memory.signal.placement->target_m).norm() <=
                            moment.configuration.rules.ball_in_place_m;
  if (!in_place) {
    memory.ball_in_place_since_s.reset();
  } else if (!memory.ball_in_place_since_s) {
    memory.ball_in_place_since_s = moment.time_s();
  }
}

bool rests_in_place(const Memory& memory, const Moment& moment) {
  return memory.ball_in_place_since_s &&
         has_passed(*memory.ball_in_place_since_s, rest_time_s(moment.configuration.rules),
                    moment.time_s());
}

Finding moves_finding(Event event, std::string_view rule, const Moment& moment, double value_m) {
  Finding finding;
  finding.event = event;
  finding.rule = rule;
  finding.value = value_m;
  finding.threshold = moment.configuration.rules.stillness_m;
  finding.unit = "m";
  if (moment.ball) finding.position_m = moment.ball->position_m;
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

// Deviation D5: one robot of each team is enough, as section 4.4 says; section 4.3 has "all
// robots".
bool is_more_on_both_sides(const LargestMoves& moves, double limit_m) {
  return std::all_of(kSides.begin(), kSides.end(),
                     [&](Side side) { return moves.robot[side] && moves.move_m[side] > limit_m; });
}

double largest_move_m(const LargestMoves& moves) {
  return std::max(moves.move_m[Side::kWest], moves.move_m[Side::kEast]);
}

Finding robots_moved(const LargestMoves& moves, const Moment& moment) {
  const double least_m = std::min(moves.move_m[Side::kWest], moves.move_m[Side::kEast]);
  Finding finding = moves_finding(Event::kRobotsMoved, "paper 4.4, WAIT_START", moment, least_m);
  for (Side side : kSides) finding.robots.push_back(*moves.robot[side]);
  finding.evidence =
      fmt::format("On each team a robot has moved by {:.1f} mm or more.", 1e3 * least_m);
  return finding;
}

Finding ready(double most_m, const Memory& memory, const Moment& moment) {
  Finding finding = moves_finding(Event::kReady, "paper 4.4, WAIT_STOP", moment, most_m);
  finding.evidence = fmt::format(
      "Within {:.2f} s no robot has moved more than {:.1f} mm, and the ball rests at its place.",
      moment.time_s() - memory.saved.time_s, 1e3 * most_m);
  return finding;
}

Finding ready_timeout(const Memory& memory, const Moment& moment) {
  const LargestMoves moves = largest_moves(memory.saved, moment.frame);
  const RuleBook& rules = moment.configuration.rules;
  Finding finding = timeout_finding(Event::kReadyTimeout, "paper 4.2, a fixed timeout",
                                    moment.time_s() - memory.wait_began_s, rules.ready_timeout_s);
  for (Side side : kSides) {
    if (moves.robot[side] && moves.move_m[side] >= rules.stillness_m) {
      finding.robots.push_back(*moves.robot[side]);
    }
  }
  if (moment.ball) finding.position_m = moment.ball->position_m;
  finding.evidence = fmt::format(
      "After {:.2f} s the wait is over: since the last look robots have moved up to {:.1f} mm, and "
      "the ball {} at its place.",
      finding.value, 1e3 * largest_move_m(moves),
      rests_in_place(memory, moment) ? "rests" : "did not rest");
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
      // Deviation D6: the paper prints r_y for r_x in this distance.
      const double move_m = (robot.position_m - before->position_m).norm();
      if (moves.robot[side] && !(move_m > moves.move_m[side])) continue;
      moves.move_m[side] = move_m;
      moves.robot[side] = RobotId{side, robot.number};
    }
  }
  return moves;
}

std::optional<Finding> find_start(Memory& memory, const Moment& moment) {
  const RuleBook& rules = moment.configuration.rules;
  if (is_look_due(memory, moment)) {
    memory.looked_s = moment.time_s();
    const LargestMoves moves = largest_moves(memory.saved, moment.frame);
    if (is_more_on_both_sides(moves, rules.stillness_m)) return robots_moved(moves, moment);
  }
  if (!has_passed(memory.wait_began_s, rules.start_timeout_s, moment.time_s())) {
    return std::nullopt;
  }
  // Deviation D2: a team that never moves must not hang a batch of games.
  Finding finding = timeout_finding(Event::kStartTimeout, "ours",
                                    moment.time_s() - memory.wait_began_s, rules.start_timeout_s);
  finding.evidence =
      fmt::format("After {:.2f} s a team has still not moved any robot.", finding.value);
  return finding;
}

std::optional<Finding> find_ready(Memory& memory, const Moment& moment) {
  const RuleBook& rules = moment.configuration.rules;
  const double now_s = moment.time_s();
  watch_ball(memory, moment);
  const bool is_late = has_passed(memory.wait_began_s, rules.ready_timeout_s, now_s);
  if (is_look_due(memory, moment)) {
    const double most_m = largest_move_m(largest_moves(memory.saved, moment.frame));
    if (most_m < rules.stillness_m && rests_in_place(memory, moment)) {
      return ready(most_m, memory, moment);
    }
    // What is saved stays for the timeout's evidence.
    if (!is_late) memory.saved = positions_in(moment.frame);
    memory.looked_s = now_s;
  }
  if (memory.signal.placement &&
      has_passed(memory.wait_began_s, rules.ready_timeout_s - kSetBallBefore_s, now_s)) {
    memory.signal.placement->at_once = true;
  }
  if (!is_late) return std::nullopt;
  return ready_timeout(memory, moment);
}

}  // namespace autoref::referee
