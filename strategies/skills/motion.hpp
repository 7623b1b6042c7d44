// Driving: from a robot and a place to be, to the robot's next order.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "soccer/field.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/tracks.hpp"

namespace autoref::strategies {

// How a team drives: less than its robots can do, so that plans hold.
struct DrivingStyle {
  double speed_mps = 3.0;       // paper, section 3: robots travel up to 3 m/s
  double braking_mps2 = 2.3;    // planned; robots brake with up to 5 m/s^2
  double approach_per_s = 6.0;  // speed per distance on the last centimetres
  double turn_per_s = 8.0;      // angular speed per angle left
  double turn_limit_radps = 10.0;
  double turn_braking_radps2 = 1e3;  // planned; a robot at its wheels' limits turns worse
  double arrived_m = 4_mm;           // nearer than this the robot stands still
};

struct Waypoint {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};  // unit vector to face
};

// Discs to keep clear of, given by centre and the distance a robot's centre keeps from it.
struct Obstacle {
  Vec2 position_m{0, 0};
  double clearance_m = 0;
};
using Obstacles = boost::container::static_vector<Obstacle, 2 * kMaxRobots + 4>;

// The point to steer for on the way to `target_m`: the target itself where the straight way is
// free, else a point beside the first obstacle on it.
Vec2 steer_around(const Vec2& from_m, const Vec2& target_m, const Obstacles& obstacles);

// Where to steer for from behind a goal or from close beside it, where the straight way to the
// field leads against its walls: first to the side, then past the goal line. None elsewhere.
std::optional<Vec2> exit_from_behind_goal(const Field& field, const Vec2& from_m);

// Commands that bring `robot` to `goal` around the obstacles and to rest there.
RobotCommand drive_to(const TrackedRobot& robot, const Waypoint& goal, const Obstacles& obstacles,
                      const DrivingStyle& style);

// The same by way of `steer_m`, the next point of a way that leads around whatever is between.
RobotCommand drive_via(const TrackedRobot& robot, const Vec2& steer_m, const Waypoint& goal,
                       const DrivingStyle& style);

// Commands that move `robot` with `velocity_mps` (in the view's frame) while it turns to `heading`.
RobotCommand drive_with(const TrackedRobot& robot, const Vec2& velocity_mps, const Vec2& heading,
                        const DrivingStyle& style);

}  // namespace autoref::strategies
