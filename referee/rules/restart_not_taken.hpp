// Deviation D10: a restart whose ball is not in play 10 s after its signal is not taken any more:
// play goes on with a force start (Laws 2014, laws 8 and 9; 2016). In 2026 the opponents have a
// free kick from there, in Division A after 5 s for free kicks; penalty kicks: rule penalty_failed.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_restart_not_taken(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kRestartNotTakenRule{
    RuleId::kRestartNotTaken, {State::kRun}, find_restart_not_taken};

}  // namespace autoref::referee
