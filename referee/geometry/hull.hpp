// How far a robot's hull reaches, and what may stand between what is seen and what is.
#pragma once

#include "soccer/geometry.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// How far the hull reaches from the robot's centre in the unit direction `direction`, in metres.
double reach_of_hull_m(const Vec2& heading, const Vec2& direction);

// By how much noise may put a robot wrong, or a distance between robot and ball, in metres: what is
// judged by a single frame must be beyond it. 0 where vision is exact.
double robot_uncertainty_m(const VisionNoise& noise);
double robot_to_ball_uncertainty_m(const VisionNoise& noise);

}  // namespace autoref::referee
