// Timeouts (Laws 7; 2026), limited in number and total length, with separate limits for extra time.
// A team gets one on request while play is stopped, except in a shoot-out and before the first
// kick-off, when the match has not begun.
//
// A timeout lasts until its team withdraws the request or has used up its time. If both teams
// request a timeout at the same time, the side that takes the restart comes first. If neither takes
// it, the side that has used less timeout time comes first. If those times are equal, the side that
// has taken fewer timeouts comes first. If these numbers are also equal, the side that did not kick
// off this half comes first.
#include <fmt/format.h>

#include "referee/machine/guards.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

bool may_have_one(const RefereeState& state, const RefereeInput& input, Side side) {
  const TimeoutAllowance allowed = timeout_allowance(state, input.configuration);
  const TimeoutBook& book = state.timeouts[side];
  return input.requests[side].timeout && book.taken < allowed.timeouts &&
         !has_passed(0, allowed.time_s, book.used_s);
}

// The side that takes the next restart; nullopt for a force start.
std::optional<Side> restarts(const RefereeState& state) {
  const std::optional<Command> next = pending_restart(state);
  if (!next) return std::nullopt;
  return is_for_one_side(next->kind) ? std::optional(next->side) : std::nullopt;
}

Side first_of_both(const RefereeState& state, const Configuration& configuration) {
  if (const std::optional<Side> side = restarts(state)) return *side;
  const TimeoutBook& west = state.timeouts[Side::kWest];
  const TimeoutBook& east = state.timeouts[Side::kEast];
  if (west.used_s != east.used_s) return west.used_s < east.used_s ? Side::kWest : Side::kEast;
  if (west.taken != east.taken) return west.taken < east.taken ? Side::kWest : Side::kEast;
  return opponent_of(kickoff_side(configuration, state.half));
}

std::optional<Side> next_in_line(const RefereeState& state, const RefereeInput& input) {
  const bool west = may_have_one(state, input, Side::kWest);
  const bool east = may_have_one(state, input, Side::kEast);
  if (west && east) return first_of_both(state, input.configuration);
  if (!west && !east) return std::nullopt;
  return west ? Side::kWest : Side::kEast;
}

std::optional<Finding> find_timeout(RefereeState& state, const RefereeInput& input) {
  if (state.signal.stage == Stage::kFirstHalfPre) return std::nullopt;
  const std::optional<Side> side = next_in_line(state, input);
  if (!side) return std::nullopt;
  const TimeoutAllowance allowed = timeout_allowance(state, input.configuration);
  const TimeoutBook& book = state.timeouts[*side];
  Finding finding = finding_of(Event::kTimeout, RuleId::kTimeouts, input.configuration.rules);
  finding.value = book.used_s;
  finding.threshold = allowed.time_s;
  finding.restart.side = *side;
  finding.evidence =
      fmt::format("{} requests timeout {} of {} with {:.1f} s left.", colour_of(*side),
                  book.taken + 1, allowed.timeouts, allowed.time_s - book.used_s);
  return finding;
}

std::optional<Finding> find_timeout_over(RefereeState& state, const RefereeInput& input) {
  const Side side = state.timeout_side;
  const double began_s = state.timeout_clock.since_s.value_or(input.time_s());
  const double left_s =
      timeout_allowance(state, input.configuration).time_s - state.timeouts[side].used_s;
  const bool is_wanted = input.requests[side].timeout;
  if (is_wanted && !has_passed(began_s, left_s, input.time_s())) return std::nullopt;
  Finding finding = finding_of(Event::kTimeoutOver, RuleId::kTimeouts, input.configuration.rules);
  finding.value = input.time_s() - began_s;
  finding.threshold = left_s;
  finding.evidence = fmt::format("{} {}.", colour_of(side),
                                 is_wanted ? "has used up its time" : "ends its timeout");
  return finding;
}

}  // namespace

constinit const Rule kTimeoutsRule{{{State::kWaitStop}, find_timeout},
                                   {{State::kTimeout}, find_timeout_over}};

}  // namespace autoref::referee
