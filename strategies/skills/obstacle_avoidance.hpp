// Paths around robots, ball and areas: the point to steer for on the way to a target.
#pragma once

#include "soccer/field.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// The obstacles for a robot of the team; the positions of moving obstacles are extrapolated.
struct Surroundings {
  const TrackedRobots& own;
  const TrackedRobots& opponents;
  double ball_room_m =
      0;  // from the ball's centre to the robot's hull; 0: the ball is not an obstacle
  Vec2 ball_m{0, 0};
  Vec2 farthest_m = Obstacles{}.farthest_m;  // largest |x| and |y| of a detour
};

// Fills `obstacles` with everything close enough to `robot` or its path to `target_m` to matter.
void find_obstacles(const Surroundings& all, const TrackedRobot& robot, const Vec2& target_m,
                    Obstacles& obstacles);

// The point to steer for: the target if the straight path is free; otherwise the better of the two
// points beside the first obstacle, judged by the length of the detour, the obstacles and walls on
// it, and the robot's current velocity.
Vec2 steer_for(const TrackedRobot& robot, const Vec2& target_m, const Obstacles& obstacles);

}  // namespace autoref::strategies
