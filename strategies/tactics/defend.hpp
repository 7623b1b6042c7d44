// Where defenders stand: the wall before the own area, and beside opponents.
#pragma once

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The place of the robot number `order` of `count` in the wall: side by side across the ball's way
// to the goal, just outside the own area.
Waypoint wall_position(const PredictedState& predicted, int order, int count);

// Between an opponent (index in the view) and the own goal, on the ball's side of it.
Waypoint mark_position(const PredictedState& predicted, int opponent);

// Opponents by how dangerous they are without the ball, the most dangerous first; those in the
// other half behind the ball are left out.
boost::container::static_vector<int, kMaxRobots> dangerous_opponents(
    const PredictedState& predicted);

}  // namespace autoref::strategies
