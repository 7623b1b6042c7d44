// Driving: commands that bring a robot to a position, avoiding robots, ball and areas.
#pragma once

#include <boost/container/static_vector.hpp>
#include <limits>
#include <optional>

#include "soccer/field.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/tracks.hpp"

namespace autoref::strategies {

// A team's driving limits, below what its robots can do, so that planned motions are feasible.
struct DrivingStyle {
  double speed_mps = 3.0;       // paper, section 3: robots travel at up to 3 m/s
  double braking_mps2 = 2.3;    // planned deceleration; robots can brake at up to 5 m/s^2
  double approach_per_s = 6.0;  // speed per metre of remaining distance, for the last centimetres
  double turn_per_s = 8.0;      // angular speed per radian of remaining angle
  double turn_limit_radps = 10.0;
  // Planned angular deceleration; robots near their wheels' limits turn more slowly.
  double turn_braking_radps2 = 1e3;
  double arrived_m = 4_mm;  // the robot stops within this distance
};

struct Waypoint {
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};  // unit vector to face
};

// A disc to avoid: its centre, and the minimum distance between that centre and the robot's centre.
struct Obstacle {
  Vec2 position_m{0, 0};
  double clearance_m = 0;
};

// The discs to avoid, and the walls if these are near the lines.
struct Obstacles : boost::container::static_vector<Obstacle, 2 * kMaxRobots + 4> {
  using static_vector::static_vector;
  // The largest |x| and |y| of a detour; see farthest_between_walls_m().
  Vec2 farthest_m = Vec2::Constant(std::numeric_limits<double>::infinity());

  // Whether a robot at `from_m` can pass the obstacle through the point `beside_m`. It can if no
  // wall is too near, or if the robot is already between the obstacle and the wall.
  bool has_room(const Obstacle& obstacle, const Vec2& from_m, const Vec2& beside_m) const;
  Vec2 inside_walls_m(const Vec2& position_m) const {
    return position_m.cwiseMax(-farthest_m).cwiseMin(farthest_m);
  }
};

// The point to steer for on the way to `target_m`: the target itself if the straight path is free,
// otherwise a point beside the first obstacle. If a wall leaves no room on one side, the point is
// on the other side. If the robot is already between obstacle and wall, the point is along the
// wall.
Vec2 steer_around(const Vec2& from_m, const Vec2& target_m, const Obstacles& obstacles);

// The point to steer for if the robot is behind or close beside a goal whose walls block the
// straight path to the field: first sideways, then past the goal line. Returns nullopt if the robot
// is elsewhere. Robots cannot get behind a goal if its side walls reach the field's wall.
std::optional<Vec2> exit_from_behind_goal(const Field& field, const Vec2& from_m);

// Commands that drive `robot` around the obstacles to `goal` and stop it there.
RobotCommand drive_to(const TrackedRobot& robot, const Waypoint& goal, const Obstacles& obstacles,
                      const DrivingStyle& style);

// The same as drive_to(), but the robot steers for `steer_m`, the next point of a path around the
// obstacles.
RobotCommand drive_via(const TrackedRobot& robot, const Vec2& steer_m, const Waypoint& goal,
                       const DrivingStyle& style);

// Commands that move `robot` with `velocity_mps` (in the view's frame) while it turns to `heading`.
RobotCommand drive_with(const TrackedRobot& robot, const Vec2& velocity_mps, const Vec2& heading,
                        const DrivingStyle& style);

// The obstacles for a robot of the team; the positions of moving obstacles are extrapolated.
struct Surroundings {
  const TrackedRobots& own;
  const TrackedRobots& opponents;
  double ball_room_m =
      0;  // gap from the ball's centre to the robot's hull; if 0, the ball is not an obstacle
  Vec2 ball_m{0, 0};
  Vec2 farthest_m = Obstacles{}.farthest_m;  // largest |x| and |y| of a detour
};

// Fills `obstacles` with everything close enough to `robot` or its path to `target_m` to matter.
void find_obstacles(const Surroundings& all, const TrackedRobot& robot, const Vec2& target_m,
                    Obstacles& obstacles);

// The point to steer for: the target if the straight path is free, otherwise the better of the two
// points beside the first obstacle, where both are judged by the length of the detour, the
// obstacles and walls along it, and the robot's current velocity.
Vec2 steer_for(const TrackedRobot& robot, const Vec2& target_m, const Obstacles& obstacles);

}  // namespace autoref::strategies
