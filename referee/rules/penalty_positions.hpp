// At a penalty kick the keeper touches its goal line between the posts, and everybody else but the
// kicker is behind the ball: 400 mm behind the penalty mark (Laws 14), 1 m behind the ball (2026,
// Penalty Kick).
//
// The kick proceeds, and its outcome decides: after a breach of the kicker's side a goal is not
// given and the kick is taken again; after one of the defenders' side it is taken again without a
// goal; after breaches of both in either case. What counts are the robots in the last frame
// before the ball was in play. Simpler than the Laws: where the keeper faces, the kick's direction
// and rebounds to robots that were wrong are not judged, and a kick has an outcome when it is a
// goal or what rule penalty_failed calls a failure.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_penalty_positions(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kPenaltyPositionsRule{
    RuleId::kPenaltyPositions, {State::kRun}, find_penalty_positions};

}  // namespace autoref::referee
