// A robot and a ball's path for tests of single skills.
#pragma once

#include "strategies/skills/ball_path.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {

// Robot 0 with heading (1, 0).
inline TrackedRobot robot_at(const Vec2& position_m, const Vec2& velocity_mps = {0, 0}) {
  return {0, position_m, Vec2(1, 0), velocity_mps, 0};
}

inline TrackedRobot numbered(int number, TrackedRobot robot) {
  robot.number = number;
  return robot;
}

inline BallPath path_of(const TrackedBall& ball) {
  BallPath path;
  path.follow(ball, 0);
  return path;
}

}  // namespace autoref::strategies
