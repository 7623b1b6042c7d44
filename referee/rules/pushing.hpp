// A robot drives an opponent back: holding (Laws 12), pushing (2026).
//
// Both travel towards the pushed one for more than 200 mm while they are in contact, whether or not
// they have the ball. A robot that drove that way itself before was not pushed.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_pushing(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kPushingRule{RuleId::kPushing, {State::kRun}, find_pushing};

}  // namespace autoref::referee
