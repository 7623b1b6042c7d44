#include "strategies/skills/play_ball.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"
#include "strategies/skills/strike.hpp"

namespace autoref::strategies {
namespace {

constexpr double kTouched_m = 130_mm;  // a robot this close to the ball has it

// Distance from the robot's centre to the ball's centre when the ball touches the front plate.
constexpr double kPlayTouch_m = kFrontDistance_m + kBallRadius_m;
constexpr double kPlayRunUp_m = 60_mm;     // gap in front of the plate before the final run
constexpr double kPlayBeside_m = 170_mm;   // distance from the ball while driving around it
constexpr double kPlayLane_m = 35_mm;      // lateral error allowed for the run through the ball
constexpr double kFastBall_mps = 1.2_mps;  // slower balls are played without being stopped
constexpr double kReachAside_m =
    600_mm;  // largest distance from the ball's path at which a robot can still intercept the ball
// How much faster than the ball the robot is during the run.
constexpr double kThrough_mps = 1.0_mps;

}  // namespace

void RestartTaker::update(const TeamView& now, int taker) {
  if (now.play != Play::kRunning) {
    number_ = taker;
    return;
  }
  const auto has_touched = [&](const TrackedRobot& robot) {
    return (robot.position_m - now.ball.position_m).norm() < kTouched_m;
  };
  const bool mate = std::any_of(now.own.begin(), now.own.end(), [&](const TrackedRobot& robot) {
    return robot.number != number_ && has_touched(robot);
  });
  if (mate || std::any_of(now.opponents.begin(), now.opponents.end(), has_touched)) number_ = -1;
}

RobotCommand play_ball(const TrackedRobot& robot, const TrackedBall& ball,
                       const Vec2& interception_m, const Intent& intent, const Obstacles& obstacles,
                       const DrivingStyle& style) {
  const Vec2 aim = direction_of(intent.target_m - interception_m, robot.heading);
  const Vec2 to_ball = interception_m - robot.position_m;
  const double behind_m = to_ball.dot(aim);     // positive: the ball is ahead
  const double beside_m = cross(aim, to_ball);  // positive: the ball is left of the lane
  const Vec2 run_up_m = interception_m - aim * (kPlayTouch_m + kPlayRunUp_m);

  if (behind_m < kPlayTouch_m * 0.6) {
    // The robot is in front of the ball or level with it, so it drives around the ball on the
    // nearer side.
    const double side = beside_m > 0 ? -1.0 : 1.0;
    const Vec2 round_m =
        interception_m - aim * kPlayTouch_m + left_of(aim) * (side * kPlayBeside_m);
    return drive_to(robot, {round_m, aim}, obstacles, style);
  }
  // At this heading, the kick sends the moving ball along the aim.
  const Vec2 heading = kick_heading(aim, intent.kick_mps, ball.velocity_mps);
  const bool in_lane = std::abs(beside_m) < kPlayLane_m && robot.heading.dot(heading) > 0.9;
  if (!in_lane) return drive_to(robot, {run_up_m, heading}, obstacles, style);

  // The robot follows the ball sideways, runs through it along the aim, and closes the lateral
  // error in proportion to its size.
  const double along_mps = std::clamp(ball.velocity_mps.dot(aim), 0.0, 1.5) + kThrough_mps;
  const Vec2 velocity_mps = ball.velocity_mps - aim * ball.velocity_mps.dot(aim) + aim * along_mps +
                            left_of(aim) * (style.approach_per_s * beside_m);
  RobotCommand command =
      drive_with(robot, clamp_norm(velocity_mps, style.speed_mps), heading, style);
  command.dribble = true;
  const double error_rad = std::abs(angle_between(robot.heading, heading));
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
  const Vec2 direction = ball.velocity_mps / speed_mps;
  const Vec2 to_robot = robot.position_m - ball.position_m;
  return to_robot.dot(direction) > kFrontDistance_m &&
         std::abs(cross(direction, to_robot)) < kReachAside_m;
}

RobotCommand receive_ball(const TrackedRobot& robot, const TrackedBall& ball,
                          const Vec2& interception_m, const Obstacles& obstacles,
                          const DrivingStyle& style) {
  const Vec2 direction = direction_of(ball.velocity_mps, -robot.heading);
  // The target stays short of the robot's own position, because otherwise the robot would drive
  // away from the ball.
  const double along_m = std::min((interception_m - ball.position_m).dot(direction),
                                  (robot.position_m - ball.position_m).dot(direction));
  const Vec2 stand_m = ball.position_m + direction * std::max(along_m, kPlayTouch_m);
  RobotCommand command = drive_to(robot, {stand_m, -direction}, obstacles, style);
  command.dribble = true;
  return command;
}

}  // namespace autoref::strategies
