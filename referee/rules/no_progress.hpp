// A ball that both teams may play and that gets nowhere for 10 s, in Division A 5 s, is started
// anew with a force start (2026, Lack Of Progress). One that rests in a defence area is the
// keeper's to play: rule keeper_holding.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_no_progress(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kNoProgressRule{RuleId::kNoProgress, {State::kRun}, find_no_progress};

}  // namespace autoref::referee
