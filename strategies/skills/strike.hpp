// Getting the ball and sending it on: fetching it, taking a pass, turning with it, kicking.
#pragma once

#include "soccer/tracks.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/skills/motion.hpp"
#include "strategies/skills/reach.hpp"

namespace autoref::strategies {

// Where the ball is to go, and how.
struct Strike {
  Vec2 target_m{0, 0};
  double kick_mps = 6;
  bool chip = false;
  double tolerance_rad = 0.06;  // kick once the heading is this near to the target
  bool first_touch = true;      // a ball that comes may be sent on without stopping it
  Vec2 keep_off{0, 0};    // unit vector out of the field where the ball lies near a line, else zero
  double bend_rad = 1.0;  // how far from the straight way to the ball the robot swings out, at most
};

// Whether the ball lies in the robot's mouth, to a few millimetres.
bool has_ball(const TrackedRobot& robot, const Vec2& ball_m);

// Whether the ball comes along at more than a walking speed and `robot` stands before it.
bool comes_towards(const TrackedRobot& robot, const BallPath& path);

// Commands for `robot` to get the ball where it meets it and to strike it. With the ball it turns,
// held by the dribbler, and kicks; a ball that comes is met on its line; any other is fetched from
// a side that needs little turning. `obstacles` are robots only.
RobotCommand strike_ball(const TrackedRobot& robot, const BallPath& path,
                         const BallInterception& interception, const Strike& strike,
                         const Obstacles& obstacles, const DrivingStyle& style);

// Commands for `robot` to kick a ball that lies still, in one touch: it goes behind the ball, lines
// up and runs into it. Before that it keeps clear of the ball.
RobotCommand take_kick(const TrackedRobot& robot, const Vec2& ball_m, const Strike& strike,
                       const Obstacles& obstacles, const DrivingStyle& style);

// Commands for a robot that has the ball to take it along with `velocity_mps` (in the view's
// frame), so that the dribbler can follow, while it turns to `heading`.
RobotCommand carry_ball(const TrackedRobot& robot, const Vec2& velocity_mps, const Vec2& heading);

}  // namespace autoref::strategies
