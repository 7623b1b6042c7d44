// The kicks of a shoot-out (Laws 2014, appendix A; 2026), instead of all other rules.
//
// A kick ends with a goal, when its time is up, when the ball is out, or when a defender has saved
// it: the defender touched the ball last, and the ball moves away from the goal. Only a goal at the
// target end scores. Fouls during a kick are not judged.
#include <fmt/format.h>

#include "referee/geometry/ball_out.hpp"
#include "referee/machine/shootout.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// A ball slower than this does not count as moving, because of vision noise.
constexpr double kMoves_mps = 0.2_mps;

bool is_saved(const RefereeInput& input, Side kicker) {
  if (input.last_touch.side != opponent_of(kicker) || !input.tracks.ball) return false;
  const double goalwards = goal_sign(opponent_of(kicker));
  return goalwards * input.tracks.ball->velocity_mps.x() < -kMoves_mps;
}

// Why the kick has failed; empty while it continues.
std::string failure_of(const RefereeState& state, const RefereeInput& input, Side kicker) {
  const Configuration& c = input.configuration;
  if (input.ball && is_out_of_field(c.field, input.ball->position_m))
    return "the ball left the field";
  if (is_saved(input, kicker)) return "the kick was saved";
  const bool is_late = has_passed(state.play.began_s, c.rules.penalty_time_s, input.time_s());
  return is_late ? "the time is up" : "";
}

// Prepares the next side's kick.
void prepare_next_kick(Finding& finding, const RefereeInput& input, Side kicker) {
  finding.restart = {CommandKind::kPreparePenalty, opponent_of(kicker)};
  finding.ball_to_m = input.configuration.field.penalty_mark_at(kicker);
}

// kGoal or kPenaltyFailed in RUN.
std::optional<Finding> find_kick_over(RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  const Side kicker = state.play.kicker.value_or(next_kicker(state.shootout, input.configuration));
  const int number = state.shootout.kicks[kicker] + 1;
  std::optional<Finding> goal = kGoalRule.find(state, input);
  if (goal && goal->restart.side == opponent_of(kicker)) {
    prepare_next_kick(*goal, input, kicker);
    goal->evidence = fmt::format("Kick {} by {}: {}", number, colour_of(kicker), goal->evidence);
    return goal;
  }
  const std::string failure = failure_of(state, input, kicker);
  if (failure.empty()) return std::nullopt;
  Finding finding = finding_of(Event::kPenaltyKickFailed, RuleId::kPenaltyKickFailed, rules);
  finding.rule = "Laws, appendix A; 2026, Shoot-Out";
  finding.value = input.time_s() - state.play.began_s;
  if (input.ball) finding.position_m = input.ball->position_m;
  prepare_next_kick(finding, input, kicker);
  finding.evidence = fmt::format("Kick {} by {} ended after {:.2f} s: {}.", number,
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
