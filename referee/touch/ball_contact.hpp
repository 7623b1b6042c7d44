// Which robots have the ball at their hull.
#pragma once

#include "soccer/tracks.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// Whether the robot has the ball: contact begins where hull and ball touch, to within 1 mm and what
// `noise` explains, and ends with "an observable separation between the ball and the robot" (Laws
// 12; 2026, Dribbling), which is 20 mm; `had` tells whether it had the ball in the frame before. A
// ball above the robot is none that it has.
bool has_ball(const TrackedRobot& robot, const TrackedBall& ball, bool had,
              const VisionNoise& noise);

}  // namespace autoref::referee
