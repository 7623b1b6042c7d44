// At a kick-off every robot is in its own half; the kicker may leave it within the centre circle
// (Laws 8; 2026, Kick-Off). Otherwise the kick-off is taken again.
//
// What counts are the robots in the last frame before the ball was in play. A robot is wrong
// where its whole hull is beyond the middle of the field; of the side that kicks off the one
// nearest to the centre is the kicker, if it is inside the circle. Robots beside the field take no
// part.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_kickoff_positions(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kKickoffPositionsRule{
    RuleId::kKickoffPositions, {State::kRun}, find_kickoff_positions};

}  // namespace autoref::referee
