#include "strategies/skills/play_ball.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies {
namespace {

// From the robot's centre to the ball's centre when the ball touches the plate.
constexpr double kTouch_m = kFrontDistance_m + kBallRadius_m;
constexpr double kRunUp_m = 60_mm;         // free way in front of the plate before the run through
constexpr double kBeside_m = 170_mm;       // distance from the ball while going round it
constexpr double kLane_m = 35_mm;          // run through the ball when this well behind it
constexpr double kFastBall_mps = 1.2_mps;  // a slower ball is played as it rolls
constexpr double kReachAside_m = 600_mm;   // from its way to a robot that can still step in
constexpr double kThrough_mps = 1.0_mps;   // faster than the ball by this on the run

}  // namespace

RobotCommand play_ball(const TrackedRobot& robot, const TrackedBall& ball, const Vec2& meeting_m,
                       const Intent& intent, const Obstacles& obstacles,
                       const DrivingStyle& style) {
  const Vec2 aim = direction_of(intent.target_m - meeting_m, robot.heading);
  const Vec2 to_ball = meeting_m - robot.position_m;
  const double behind_m = to_ball.dot(aim);     // positive: the ball lies ahead
  const double beside_m = cross(aim, to_ball);  // positive: the ball lies to the left of the lane
  const Vec2 run_up_m = meeting_m - aim * (kTouch_m + kRunUp_m);

  if (behind_m < kTouch_m * 0.6) {
    // In front of or level with the ball: go round it, on the side the robot is on.
    const double side = beside_m > 0 ? -1.0 : 1.0;
    const Vec2 round_m = meeting_m - aim * kTouch_m + left_of(aim) * (side * kBeside_m);
    return drive_to(robot, {round_m, aim}, obstacles, style);
  }
  const bool in_lane = std::abs(beside_m) < kLane_m && robot.heading.dot(aim) > 0.9;
  if (!in_lane) return drive_to(robot, {run_up_m, aim}, obstacles, style);

  const double along_mps = std::clamp(ball.velocity_mps.dot(aim), 0.0, 1.5) + kThrough_mps;
  const Vec2 velocity_mps = ball.velocity_mps - aim * ball.velocity_mps.dot(aim) + aim * along_mps +
                            left_of(aim) * (style.approach_per_s * beside_m);
  RobotCommand command = drive_with(robot, clamp_norm(velocity_mps, style.speed_mps), aim, style);
  command.dribble = true;
  const double error_rad = std::abs(angle_between(robot.heading, aim));
  if (error_rad < intent.tolerance_rad) {
    command.kick_mps = intent.kick_mps;
  } else if (error_rad < intent.hasty_tolerance_rad) {
    command.kick_mps = intent.hasty_mps;
  }
  return command;
}

bool comes_at(const TrackedRobot& robot, const TrackedBall& ball) {
  const double speed_mps = ball.velocity_mps.norm();
  if (speed_mps < kFastBall_mps) return false;
  const Vec2 way = ball.velocity_mps / speed_mps;
  const Vec2 to_robot = robot.position_m - ball.position_m;
  return to_robot.dot(way) > kFrontDistance_m && std::abs(cross(way, to_robot)) < kReachAside_m;
}

RobotCommand receive_ball(const TrackedRobot& robot, const TrackedBall& ball, const Vec2& meeting_m,
                          const Obstacles& obstacles, const DrivingStyle& style) {
  const Vec2 way = direction_of(ball.velocity_mps, -robot.heading);
  // Not beyond where the robot is: it would run away from the ball.
  const double along_m = std::min((meeting_m - ball.position_m).dot(way),
                                  (robot.position_m - ball.position_m).dot(way));
  const Vec2 stand_m = ball.position_m + way * std::max(along_m, kTouch_m);
  RobotCommand command = drive_to(robot, {stand_m, -way}, obstacles, style);
  command.dribble = true;
  return command;
}

}  // namespace autoref::strategies
