// Distances of a robot's hull, computed from sampled points of its outline.
#pragma once

#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::judge::ground_truth {

// Minimum and maximum over all points of the outline.
struct Reach {
  double nearest_m = 0;
  double farthest_m = 0;
};

// Distances to the defence area of `side`, negative inside; exact to 0.05 mm.
Reach reach_to_area(const Field& field, Side side, const sim::RobotState& robot);

// Distances from the halfway line into the half of `side`, negative in the other half.
Reach reach_into_half(Side side, const sim::RobotState& robot);

// Distance from a robot's hull to the ball's centre, which rules call the distance to the ball.
double hull_to_ball_m(const sim::RobotState& robot, const sim::BallState& ball);

// Returns whether two robots are in contact, treated as discs, as in the simulated physics. They
// may be slightly apart in some frames of a lasting contact.
bool are_in_contact(const sim::RobotState& a, const sim::RobotState& b);

}  // namespace autoref::judge::ground_truth
