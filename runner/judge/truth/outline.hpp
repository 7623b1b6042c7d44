// Where a robot's hull lies: distances of its outline, taken point by point.
#pragma once

#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::runner::ground_truth {

// Of all points of a robot's outline.
struct Reach {
  double nearest_m = 0;
  double farthest_m = 0;
};

// Distances to the defence area of `side`, negative inside; exact to 0.05 mm.
Reach reach_to_area(const Field& field, Side side, const sim::RobotState& robot);

// Distances from the halfway line into the half of `side`, negative in the other one.
Reach reach_into_half(Side side, const sim::RobotState& robot);

// From a robot's hull to the ball's centre: what a rule calls the distance to the ball.
double hull_to_ball_m(const sim::RobotState& robot, const sim::BallState& ball);

// Whether the hulls of two robots are in contact: as the plane's physics has it, two discs. They
// may stand a little apart in a frame of a contact that lasts.
bool are_in_contact(const sim::RobotState& a, const sim::RobotState& b);

}  // namespace autoref::runner::ground_truth
