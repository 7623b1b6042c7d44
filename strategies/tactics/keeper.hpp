// The goalkeeper.
#pragma once

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// Where the keeper stands: on the way of a ball that will be in the goal; else on the line that
// halves the goal's angle seen from the ball, ahead of the goal line by the style's keeper_out_m,
// and nearer to where an opponent with the ball at its foot faces, if that is the goal.
Waypoint keeper_position(const PredictedState& predicted, const TrackedRobot& keeper);

// Commands for the keeper, the robot of that index, while it does not play the ball.
RobotCommand keep_goal(const PredictedState& predicted, int index);

// Whether the ball lies where only the keeper should play it, and slowly enough to be fetched.
bool is_keepers_ball(const PredictedState& predicted);

}  // namespace autoref::strategies
