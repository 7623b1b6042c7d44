// A robot dribbles the ball over 500 mm, later 1 m, "measured linearly from the ball location where
// the dribbling started" (Laws 12; 2026). It dribbles from the first contact to an observable
// separation.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_dribbling(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kDribblingRule{RuleId::kDribbling, {State::kRun}, find_dribbling};

}  // namespace autoref::referee
