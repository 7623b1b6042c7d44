// A kick from one's own half over the opponents' goal line outside the goal, untouched on its way,
// is aimless, except from a kick-off (2026 Division B): a free kick from where it was kicked.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_aimless_kick(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kAimlessKickRule{RuleId::kAimlessKick, {State::kRun}, find_aimless_kick};

}  // namespace autoref::referee
