// The extent of a robot's hull, and the uncertainty of its position.
#pragma once

#include "soccer/geometry.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// Distance in metres from the robot's centre to its hull in the unit direction `direction`.
double reach_of_hull_m(const Vec2& heading, const Vec2& direction);

// Uncertainty in metres of a robot's position, or of a distance between robot and ball, from vision
// noise. If a call is based on a single frame, the violation must exceed this uncertainty. The
// uncertainty is 0 if vision is exact.
double robot_uncertainty_m(const tracking::VisionNoise& noise);
double robot_to_ball_uncertainty_m(const tracking::VisionNoise& noise);

}  // namespace autoref::referee
