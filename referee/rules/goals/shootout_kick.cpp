// The kicks of a shoot-out (Laws 2014, appendix A; 2026). This rule replaces the rules on goals,
// exits and restarts not taken in time; fouls are judged as in play (RuleEntry::in_shootout).
//
// A kick ends when it has scored or failed (penalty_outcome.hpp). Only a goal at the target end
// scores. Each kick is a penalty kick: a foul by the kicker's side ends it without a goal, and in
// 2026 a foul by the defenders is a goal. Under the Laws, such a foul is only counted, since
// neither a free kick nor another penalty kick can follow within a shoot-out.
#include <fmt/format.h>

#include "referee/machine/penalty_outcome.hpp"
#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// Prepares the next side's kick.
void prepare_next_kick(Finding& finding, const RefereeInput& input, Side kicker) {
  finding.restart = {CommandKind::kPreparePenalty, opponent_of(kicker)};
  finding.ball_to_m = input.configuration.field.penalty_mark_at(kicker);
}

// The goal, if the kick has scored.
std::optional<Finding> find_goal_of_kick(RefereeState& state, const RefereeInput& input) {
  if (is_goal_awarded(state, input)) return awarded_goal(state, input);
  std::optional<Finding> goal = kGoalRule.find(state, input);
  if (goal && goal->restart.side != opponent_of(*state.play.kicker)) goal.reset();
  return goal;
}

// Why the kick has failed, as part of a sentence; empty while it continues.
std::string failure_of(RefereeState& state, const RefereeInput& input) {
  if (const std::optional<PenaltyFailure> failure = penalty_failure(state, input))
    return failure->evidence;
  if (!input.configuration.rules.has(RuleId::kChippedGoal)) return "";
  const std::optional<Finding> chip = kChippedGoalRule.find(state, input);
  return chip ? chip->evidence : "";
}

// kGoal or kPenaltyKickFailed in RUN.
std::optional<Finding> find_kick_over(RefereeState& state, const RefereeInput& input) {
  if (!state.play.kicker) return std::nullopt;  // play was joined midway
  const Side kicker = *state.play.kicker;
  const int number = state.shootout.kicks[kicker] + 1;
  const std::string failure = failure_of(state, input);
  if (failure.empty()) {
    std::optional<Finding> goal = find_goal_of_kick(state, input);
    if (!goal) return std::nullopt;
    prepare_next_kick(*goal, input, kicker);
    goal->evidence = fmt::format("Kick {} by {}: {}", number, colour_of(kicker), goal->evidence);
    return goal;
  }
  const RuleBook& rules = input.configuration.rules;
  Finding finding = finding_of(Event::kPenaltyKickFailed, RuleId::kPenaltyKickFailed, rules);
  finding.rule = "Laws, appendix A; 2026, Shoot-Out";
  finding.value = input.time_s() - state.play.began_s;
  if (input.ball) finding.position_m = input.ball->position_m;
  prepare_next_kick(finding, input, kicker);
  finding.evidence = fmt::format("Kick {} by {} ended after {:.2f} s. {}", number,
                                 colour_of(kicker), finding.value, failure);
  return finding;
}

// kShootoutOver between two kicks, once the winner is certain.
std::optional<Finding> find_shootout_over(RefereeState& state, const RefereeInput& input) {
  const ShootoutBook& book = state.shootout;
  const int kicks = input.configuration.rules.shootout_kicks;
  if (!is_over(book, kicks)) return std::nullopt;
  Finding finding;
  finding.event = Event::kShootoutOver;
  finding.rule = "Laws, appendix A; 2026, Shoot-Out";
  finding.evidence =
      fmt::format("Yellow scored with {} of {} kicks, blue with {} of {}{}.",
                  book.goals[Side::kWest], book.kicks[Side::kWest], book.goals[Side::kEast],
                  book.kicks[Side::kEast], is_decided(book, kicks) ? "" : "; a draw at the limit");
  return finding;
}

}  // namespace

constinit const Rule kShootoutRule{{{State::kRun}, find_kick_over},
                                   {{State::kDelayWait, State::kWaitStop}, find_shootout_over}};

}  // namespace autoref::referee
