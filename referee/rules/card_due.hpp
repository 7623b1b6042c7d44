// Cards for fouls, and the end of yellow ones. "Every third foul of the same team results in a
// yellow card"; a third active yellow card is a red one instead (2026). A yellow card lasts some
// time of play (Laws 12).
//
// Where both sides are due in one frame, one finding without an offender stands for both.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_yellow_card(RefereeState& state, const RefereeInput& input);
std::optional<Finding> find_red_card(RefereeState& state, const RefereeInput& input);
std::optional<Finding> find_card_over(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kYellowCardRule{
    RuleId::kCards, {State::kRun, State::kWaitStop}, find_yellow_card};
inline constexpr Rule kRedCardRule{RuleId::kCards, {State::kRun, State::kWaitStop}, find_red_card};
inline constexpr Rule kCardOverRule{RuleId::kCards, {State::kRun}, find_card_over};

}  // namespace autoref::referee
