// Estimated times for robots to reach points and the moving ball.
#pragma once

#include "soccer/tracks.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

// Time in seconds until `robot` can stand at `point_m`: accelerate, cruise and brake along the
// straight path, starting from its current velocity.
double time_to_s(const TrackedRobot& robot, const Vec2& point_m, const Abilities& abilities);

// Where and when a robot can first reach the ball.
struct BallInterception {
  Vec2 point_m{0, 0};
  double time_s = 0;  // time from now until both robot and ball are there
};

// The first point of the ball's path that `robot` reaches no later than the ball; if it cannot
// catch up, the end of the path. Points outside the field do not count.
BallInterception intercept(const TrackedRobot& robot, const BallPath& path,
                           const Abilities& abilities, const Field& field);

}  // namespace autoref::strategies
