// Opponents keep 500 mm away from the ball until it is in play (Laws 8 and 13; 2026, Defender Too
// Close To Ball). Penalty kicks have their own position rules.
//
// Under the Laws the restart is retaken, and a robot that was also too near at the previous attempt
// gets a yellow card. Positions are judged in the last frame before the ball is in play, so a robot
// that starts when it sees the kick is not at fault. In 2026 the violation is an immediate team
// foul that counts again after 2 s, and the time for the kick restarts.
#include <fmt/format.h>
#include <algorithm>

#include "referee/geometry/hull.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Measured from where the ball was before the kick, so that a kick towards an opponent does not
// shorten the distance.
double distance_to_ball_m(const RobotObservation& robot, const PlayState& play) {
  return distance_to_hull(*play.ball_from_m, robot.position_m, robot.heading);
}

PositionViolation too_near(Side side, const PlayState& play, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const double least_m = c.rules.opponents_to_ball_m - robot_to_ball_uncertainty_m(c.noise);
  PositionViolation found;
  for (const RobotObservation& robot : input.frame.robots[side]) {
    const double distance_m = distance_to_ball_m(robot, play);
    if (distance_m < least_m) {
      found.add({side, robot.number}, distance_m, distance_m < found.worst_m);
    }
  }
  return found;
}

Finding taken_again(const PositionViolation& before, const RefereeState& state,
                    const RefereeInput& input) {
  const PlayState& play = state.play;
  Finding finding = finding_of(Event::kDefenderTooCloseToKickPoint,
                               RuleId::kDefenderTooCloseToKickPoint, input.configuration.rules);
  finding.value = before.worst_m;
  finding.details.robot = before.worst;
  finding.robots = before.robots;
  finding.offender = opponent_of(*play.kicker);
  finding.position_m = play.ball_from_m;
  const bool is_repeated =
      std::any_of(before.robots.begin(), before.robots.end(),
                  [&state](RobotId robot) { return state.retakes.too_near.has(robot); });
  if (is_repeated) finding.card = Card::kYellow;
  take_again(finding, play);
  finding.evidence = fmt::format(
      "Just before the ball entered play, the hull of {} was {} from the ball{}: {} again.",
      before.robots.size() == 1 ? text_of(before.robots.front()) : "the nearest opponent",
      mm_text(before.worst_m), is_repeated ? ", as at the restart before" : "",
      name_of(play.restart));
  return finding;
}

// Under the Laws, the rule is judged when the ball enters play.
std::optional<Finding> find_when_taken(RefereeState& state, const RefereeInput& input) {
  PositionViolation& before = state.watch.defender_too_close_to_kick_point.before;
  if (!state.play.in_play) {
    before = too_near(opponent_of(*state.play.kicker), state.play, input);
    return std::nullopt;
  }
  if (!state.play.entered_now || !before.any() ||
      !may_be_taken_again(state, input.configuration.rules))
    return std::nullopt;
  return taken_again(before, state, input);
}

// Under the rules of 2026, the rule is judged while the kick has not been taken.
std::optional<Finding> find_while_waiting(RefereeState& state, const RefereeInput& input) {
  if (state.play.in_play) return std::nullopt;
  const RuleBook& rules = input.configuration.rules;
  std::optional<double>& called_s = state.watch.defender_too_close_to_kick_point.called_s;
  if (called_s && !has_passed(*called_s, rules.foul_repeat_s, input.time_s())) return std::nullopt;
  const Side side = opponent_of(*state.play.kicker);
  const PositionViolation near = too_near(side, state.play, input);
  if (!near.any()) return std::nullopt;
  called_s = input.time_s();
  Finding finding =
      finding_of(Event::kDefenderTooCloseToKickPoint, RuleId::kDefenderTooCloseToKickPoint, rules);
  finding.value = near.worst_m;
  finding.details.robot = near.worst;
  finding.robots = near.robots;
  finding.offender = side;
  finding.position_m = state.play.ball_from_m;
  if (rules.fouls_stop_play) take_again(finding, state.play);
  finding.evidence =
      fmt::format("The hull of {} is {} from the ball, which is not yet in play.",
                  near.robots.size() == 1 ? text_of(near.robots.front()) : "the nearest opponent",
                  mm_text(near.worst_m));
  return finding;
}

std::optional<Finding> find_defender_too_close_to_kick_point(RefereeState& state,
                                                             const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.kicker || play.is_penalty() || !play.ball_from_m) return std::nullopt;
  const bool is_2026 = input.configuration.rules.edition == Edition::kRules2026;
  return is_2026 ? find_while_waiting(state, input) : find_when_taken(state, input);
}

}  // namespace

constinit const Rule kDefenderTooCloseToKickPointRule{{State::kRun},
                                                      find_defender_too_close_to_kick_point};

}  // namespace autoref::referee
