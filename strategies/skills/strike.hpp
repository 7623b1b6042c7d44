// Getting the ball and kicking it: fetching it, receiving passes, turning with the ball, kicking.
#pragma once

#include "soccer/tracks.hpp"
#include "strategies/skills/ball_path.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// The target of a kick and how to kick.
struct Strike {
  Vec2 target_m{0, 0};
  double kick_mps = 6;
  bool chip = false;
  double tolerance_rad = 0.06;  // largest heading error for a kick
  double commit_rad = 0;  // if larger, replaces `tolerance_rad` for a kick of a resting ball once
                          // the robot is at it
  // Whether a robot that is to kick a resting ball at speed 0 takes the ball along.
  bool dribble = false;
  bool first_touch = true;  // whether an incoming ball may be kicked without stopping it first
  Vec2 keep_off{0, 0};  // unit vector out of the field if the ball is near a line, otherwise zero
  // Largest angle between the robot's course and the straight path to the ball.
  double bend_rad = 1.0;
  double turn_radps = 6.0;  // maximum angular velocity with the ball, and the angular deceleration
  double turn_braking_radps2 = 16.0;  // planned for it
};

// The minimum cosine between a first-touch kick and the direction back along the ball's path, and
// that angle.
inline constexpr double kWideFirstTouch = 0.45;
inline constexpr double kWideFirstTouch_rad = 1.1040309877;

// The velocity of a ball that is at the middle of the robot's plate and moves with it.
Vec2 plate_mps(const TrackedRobot& robot);

// The velocity of a ball after a kick along `heading`, if `ball_mps` was its velocity before.
// Across the heading, the ball keeps its motion (sim/kicker.hpp). `along_mps` is the kick's speed
// over ground; for a chip, its horizontal part.
Vec2 kicked_mps(const Vec2& heading, double along_mps, const Vec2& ball_mps);

// The heading at which a robot must kick to send the ball along `aim`; `aim` itself if there is no
// kick.
Vec2 kick_heading(const Vec2& aim, double along_mps, const Vec2& ball_mps);

// Whether the ball is in the robot's dribbler zone, with a tolerance of a few millimetres.
bool has_ball(const TrackedRobot& robot, const Vec2& ball_m);

// Whether the ball approaches at more than 1.8 m/s and `robot` is in or close beside the ball's
// path.
bool comes_towards(const TrackedRobot& robot, const BallPath& path);

// Commands for `robot` to get the ball at the interception and kick it. If it has the ball, it
// turns using the dribbler and kicks. It meets an incoming ball on the ball's path. It fetches any
// other ball from a side that needs little turning. `obstacles` must contain only robots.
RobotCommand strike_ball(const TrackedRobot& robot, const BallPath& path,
                         const BallInterception& interception, const Strike& strike,
                         const Obstacles& obstacles, const DrivingStyle& style);

// Commands for `robot` to kick a ball at rest with one touch: it drives behind the ball, aligns and
// runs into it. Until then it keeps clear of the ball.
RobotCommand take_kick(const TrackedRobot& robot, const Vec2& ball_m, const Strike& strike,
                       const Obstacles& obstacles, const DrivingStyle& style);

// Commands for a robot with the ball to dribble it with `velocity_mps` (in the view's frame) while
// turning to `heading`. The motion is slow enough for the dribbler to keep the ball, and the turn
// is as fast as `strike` allows.
RobotCommand carry_ball(const TrackedRobot& robot, const Vec2& velocity_mps, const Vec2& heading,
                        const Strike& strike = {});

}  // namespace autoref::strategies
