#include "referee/person/official.hpp"

#include <algorithm>
#include <utility>

#include "referee/geometry/ball_out.hpp"
#include "referee/machine/ball_placement.hpp"
#include "referee/machine/guards.hpp"
#include "referee/machine/readiness.hpp"

namespace autoref::referee {

Official::Official(const Configuration& configuration) {
  state_.signal.next_command =
      Command{CommandKind::kPrepareKickoff, kickoff_side(configuration, 0)};
}

std::optional<Finding> Official::follow(const RefereeSignal& /*given*/,
                                        const RefereeInput& /*input*/) {
  return std::nullopt;
}

std::optional<Finding> Official::find_before_rules(const RefereeInput& /*input*/) {
  return std::nullopt;
}

std::optional<Finding> Official::find(const RefereeInput& input) {
  switch (state_.machine_state) {
    case State::kInit:
      return passed_by_itself(Event::kBegin);
    case State::kWaitStart:
      return find_start(state_, input);
    case State::kWaitStop:
      return is_placement_due(state_) ? find_placement_step(state_, input)
                                      : find_ready(state_, input);
    case State::kPlacement:
      return find_placement_outcome(state_, input);
    case State::kDelayWait:
      if (!has_passed(state_.delay_ends_s, 0, input.time_s())) return std::nullopt;
      return passed_by_itself(Event::kSignalled);
    case State::kRun:
    case State::kTimeout:
    case State::kOver:
    case State::kCalled:
      break;
  }
  return std::nullopt;
}

std::optional<Finding> Official::find_time_over(const RefereeInput& input) {
  return referee::find_time_over(state_, input);
}

std::optional<Step> Official::next(const RefereeInput& input, const Finding& finding) {
  return if_taken(step(state_, input, finding));
}

void Official::enter(const RefereeInput& /*input*/, const Finding& /*finding*/, Step step) {
  state_ = std::move(step.state);
}

void Official::show_time(const RefereeInput& input) {
  const double now_s = input.time_s();
  RefereeSignal& signal = state_.signal;
  signal.stage_time_left_s = time_left_s(state_, input.configuration, now_s);
  const double played_s = state_.play_clock.at_s(now_s);
  const bool has_timeouts = input.configuration.rules.has(RuleId::kTimeouts);
  const TimeoutAllowance allowance =
      has_timeouts ? timeout_allowance(state_, input.configuration) : TimeoutAllowance{};
  for (const Side side : kSides) {
    const CardBook& cards = state_.cards[side];
    signal.fouls[side] = cards.fouls;
    signal.yellow_left_s[side].clear();
    for (const double end_s : cards.yellow_ends_s)
      signal.yellow_left_s[side].push_back(std::max(0.0, end_s - played_s));
    const TimeoutBook& book = state_.timeouts[side];
    const bool takes_one = state_.machine_state == State::kTimeout && state_.timeout_side == side;
    const double running_s = takes_one ? state_.timeout_clock.running_s(now_s) : 0;
    signal.timeouts_left[side] = std::max(0, allowance.timeouts - book.taken);
    signal.timeout_left_s[side] = std::max(0.0, allowance.time_s - book.used_s - running_s);
  }
}

void Official::forget(const Frame& frame) {
  state_.watch = RuleWatch{};
  state_.ball_in_position_since_s.reset();
  state_.saved = positions_in(frame);
}

std::optional<Step> if_taken(Step step) {
  return step.transition != nullptr ? std::optional(std::move(step)) : std::nullopt;
}

bool is_ball_out(const RefereeInput& input) {
  return input.ball && is_out_of_field(input.configuration.field, input.ball->position_m);
}

Finding passed_by_itself(Event event) {
  Finding finding;
  finding.event = event;
  finding.rule = "paper 4.3";
  return finding;
}

}  // namespace autoref::referee
