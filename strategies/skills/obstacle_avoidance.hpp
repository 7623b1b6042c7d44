// Ways around robots, ball and areas: where to steer for now on the way to somewhere.
#pragma once

#include "soccer/field.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// What a robot of the team drives around, moved on to where it will be met.
struct Surroundings {
  const TrackedRobots& own;
  const TrackedRobots& opponents;
  double ball_room_m =
      0;  // from the ball's centre to the robot's hull; 0: the ball is no hindrance
  Vec2 ball_m{0, 0};
};

// Fills `obstacles` with what is near enough to matter to `robot` on its way to `target_m`.
void find_obstacles(const Surroundings& all, const TrackedRobot& robot, const Vec2& target_m,
                    Obstacles& obstacles);

// The point to steer for: the target where the straight way is free; else the better of the two
// points beside the first obstacle, by the length of the detour, what stands in its way, and how
// the robot already moves.
Vec2 steer_for(const TrackedRobot& robot, const Vec2& target_m, const Obstacles& obstacles);

}  // namespace autoref::strategies
