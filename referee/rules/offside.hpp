// Offside, for experiments: no rule book of the league has it. The definition is ours, see
// referee/README.md.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_offside(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kOffsideRule{RuleId::kOffside, {State::kRun}, find_offside};

}  // namespace autoref::referee
