// The goalkeeper.
#pragma once

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The keeper's position: in the path of a ball that is going into the goal; otherwise on the
// bisector of the goal's angle seen from the ball, the style's keeper_out_m ahead of the goal line,
// shifted towards the point at which an opponent with the ball aims, if that point is in or near
// the goal.
Waypoint keeper_position(const PredictedState& predicted, const TrackedRobot& keeper);

// Commands for the keeper (the robot with that index) while it does not play the ball.
RobotCommand keep_goal(const PredictedState& predicted, int index);

// Whether the ball is where only the keeper should play it, and slow enough to be fetched.
bool is_keepers_ball(const PredictedState& predicted);

}  // namespace autoref::strategies
