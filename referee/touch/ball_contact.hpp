// Which robots are in contact with the ball.
#pragma once

#include "soccer/tracks.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// Whether the robot is in contact with the ball. Contact begins when the gap between hull and ball
// is below 1 mm plus one standard deviation of `noise`, and ends with "an observable separation
// between the ball and the robot" (Laws 12; 2026, Dribbling), taken as 20 mm. `had` is whether it
// was in contact in the previous frame. A ball above the robot is not in contact.
bool has_ball(const TrackedRobot& robot, const TrackedBall& ball, bool had,
              const tracking::VisionNoise& noise);

}  // namespace autoref::referee
