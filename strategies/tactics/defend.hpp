// Positions of defenders: the wall in front of the team's own area, and markers.
#pragma once

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The position of robot number `order` of `count` in the wall. The robots stand side by side across
// the ball's path to the goal, just outside the team's own area.
Waypoint wall_position(const PredictedState& predicted, int order, int count);

// The position of robot number `order` of a wall at a free kick behind which no robot fits
// (PredictedState::has_no_room_behind_kick). The robots stand on both sides of the shot at the
// middle of the goal, as near to it as the rules allow, so that the keeper can cover the gap.
Waypoint split_wall_position(const PredictedState& predicted, int order);

// A marker's position between an opponent (index in the view) and the team's own goal, shifted
// towards the ball.
Waypoint mark_position(const PredictedState& predicted, int opponent);

// Opponents without the ball, most dangerous first. Opponents far into the other half are left out.
boost::container::static_vector<int, kMaxRobots> dangerous_opponents(
    const PredictedState& predicted);

}  // namespace autoref::strategies
