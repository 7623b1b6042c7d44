// A goal counts only if the ball has not risen above 0.15 m since the scoring team's last touch, if
// that team has committed no non-stopping foul in the 2 s before the goal, and if it has no more
// robots on the field than allowed. Penalty goals always count (2026, Scoring Goals). Otherwise,
// the restart is the same as if the ball had crossed the goal line next to the goal.
//
// A ball of unknown height counts as being on the ground. If an unknown robot has touched the ball
// since the scoring team's last touch, the goal stands. The height is measured at the ball's top,
// as in the Laws.
#include <fmt/format.h>

#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"
#include "referee/rules/too_many_robots.hpp"

namespace autoref::referee {
namespace {

Finding invalid(const RefereeState& state, const RefereeInput& input, Side conceded) {
  Finding finding =
      finding_of(Event::kInvalidGoal, RuleId::kInvalidGoal, input.configuration.rules);
  if (input.last_touch.robot) finding.robots.push_back(*input.last_touch.robot);
  finding.offender = opponent_of(conceded);
  add_shot(finding, state.play.touches, input, opponent_of(conceded));
  finding.position_m = input.ball->position_m;
  if (input.last_touch.side == conceded) {
    restart_with_corner_kick(finding, input, conceded);
  } else {
    restart_with_goal_kick(finding, input, conceded);
  }
  return finding;
}

std::optional<Finding> find_invalid_goal(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const std::optional<Side> conceded = conceding_side(state.play, input);
  if (!conceded || began_with_penalty(state.play, c.field)) return std::nullopt;
  const Side scorer = opponent_of(*conceded);
  const std::optional<double> top_m = top_since_touch_m(state.play.touches, scorer);
  if (top_m && *top_m > c.rules.chip_height_m) {
    Finding finding = invalid(state, input, *conceded);
    finding.value = *top_m;
    finding.evidence = fmt::format("The ball rose to {:.0f} mm after {} touched it.", 1e3 * *top_m,
                                   colour_of(scorer));
    return finding;
  }
  const int robots = robots_on_field(input, scorer);
  if (robots > state.signal.robots_allowed[scorer]) {
    Finding finding = invalid(state, input, *conceded);
    finding.value = robots;
    finding.threshold = state.signal.robots_allowed[scorer];
    finding.unit = "robots";
    finding.evidence = fmt::format("{} had {} robots on the field, but only {} were allowed.",
                                   colour_of(scorer), robots, state.signal.robots_allowed[scorer]);
    return finding;
  }
  const std::optional<double>& fouled_s = state.cards[scorer].fouled_s;
  if (!fouled_s || input.time_s() - *fouled_s > c.rules.goal_after_foul_s) return std::nullopt;
  Finding finding = invalid(state, input, *conceded);
  finding.value = input.time_s() - *fouled_s;
  finding.threshold = c.rules.goal_after_foul_s;
  finding.unit = "s";
  finding.evidence = fmt::format("{} committed a foul {:.3f} s before the goal.", colour_of(scorer),
                                 finding.value);
  return finding;
}

}  // namespace

constinit const Rule kInvalidGoalRule{{State::kRun}, find_invalid_goal};

}  // namespace autoref::referee
