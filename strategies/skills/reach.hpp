// How soon robots get where: times to points and to the moving ball.
#pragma once

#include "soccer/tracks.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

// Seconds until `robot` can stand at `point_m`: speeds up, travels, brakes; from its present
// velocity along the straight way.
double time_to_s(const TrackedRobot& robot, const Vec2& point_m, const Abilities& abilities);

// Where and when a robot can first have the ball.
struct BallInterception {
  Vec2 point_m{0, 0};
  double time_s = 0;  // from now until robot and ball are there
};

// The first point of the ball's way that `robot` reaches no later than the ball; where it cannot
// catch up, the end of the path. Points outside the field do not count.
BallInterception intercept(const TrackedRobot& robot, const BallPath& path,
                           const Abilities& abilities, const Field& field);

}  // namespace autoref::strategies
