#include "referee/rules/team_timeout.hpp"

#include <fmt/format.h>

#include "referee/machine/timekeeping.hpp"

namespace autoref::referee {
namespace {

struct Allowance {
  int timeouts = 0;
  double time_s = 0;
};

Allowance allowance_of(const Memory& memory, const Configuration& configuration) {
  const RuleBook& rules = configuration.rules;
  if (is_extra(configuration, memory.half)) return {rules.extra_timeouts, rules.extra_timeouts_s};
  return {rules.timeouts, rules.timeouts_s};
}

bool may_have_one(const Memory& memory, const Moment& moment, Side side) {
  const Allowance allowed = allowance_of(memory, moment.configuration);
  const TimeoutBook& book = memory.timeouts[side];
  return moment.requests[side].timeout && book.taken < allowed.timeouts &&
         !has_passed(0, allowed.time_s, book.used_s);
}

// Who takes the restart that play goes on with; none for a force start.
std::optional<Side> restarts(const Memory& memory) {
  const std::optional<Command>& next = memory.signal.next_command;
  if (!next) return std::nullopt;
  if (next->kind == CommandKind::kNormalStart && memory.prepared) return memory.prepared->side;
  return is_for_one_side(next->kind) ? std::optional(next->side) : std::nullopt;
}

Side first_of_both(const Memory& memory, const Configuration& configuration) {
  if (const std::optional<Side> side = restarts(memory)) return *side;
  const TimeoutBook& west = memory.timeouts[Side::kWest];
  const TimeoutBook& east = memory.timeouts[Side::kEast];
  if (west.used_s != east.used_s) return west.used_s < east.used_s ? Side::kWest : Side::kEast;
  if (west.taken != east.taken) return west.taken < east.taken ? Side::kWest : Side::kEast;
  return opponent_of(kickoff_side(configuration, memory.half));
}

std::optional<Side> next_in_line(const Memory& memory, const Moment& moment) {
  const bool west = may_have_one(memory, moment, Side::kWest);
  const bool east = may_have_one(memory, moment, Side::kEast);
  if (west && east) return first_of_both(memory, moment.configuration);
  if (!west && !east) return std::nullopt;
  return west ? Side::kWest : Side::kEast;
}

}  // namespace

std::optional<Finding> find_timeout(Memory& memory, const Moment& moment) {
  if (memory.signal.stage == Stage::kFirstHalfPre) return std::nullopt;
  const std::optional<Side> side = next_in_line(memory, moment);
  if (!side) return std::nullopt;
  const Allowance allowed = allowance_of(memory, moment.configuration);
  const TimeoutBook& book = memory.timeouts[*side];
  Finding finding = finding_of(Event::kTimeout, RuleId::kTimeouts, moment.configuration.rules);
  finding.value = book.used_s;
  finding.threshold = allowed.time_s;
  finding.restart = {CommandKind::kTimeout, *side};
  finding.evidence = fmt::format("{} asks for timeout {} of {}; {:.1f} s are left.", name_of(*side),
                                 book.taken + 1, allowed.timeouts, allowed.time_s - book.used_s);
  return finding;
}

std::optional<Finding> find_timeout_over(Memory& memory, const Moment& moment) {
  const Side side = memory.timeout_side;
  const double began_s = memory.timeout_clock.since_s.value_or(moment.time_s());
  const double left_s =
      allowance_of(memory, moment.configuration).time_s - memory.timeouts[side].used_s;
  const bool is_wanted = moment.requests[side].timeout;
  if (is_wanted && !has_passed(began_s, left_s, moment.time_s())) return std::nullopt;
  Finding finding = finding_of(Event::kTimeoutOver, RuleId::kTimeouts, moment.configuration.rules);
  finding.value = moment.time_s() - began_s;
  finding.threshold = left_s;
  finding.evidence =
      fmt::format("{} {}.", name_of(side), is_wanted ? "has no time left" : "needs no more");
  return finding;
}

}  // namespace autoref::referee
