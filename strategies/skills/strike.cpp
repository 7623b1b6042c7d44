#include "strategies/skills/strike.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {
namespace {

constexpr double kStrikeTouch_m = kFrontDistance_m + kBallRadius_m;
constexpr double kInDribblerZone_m =
    18_mm;  // largest gap between the plate and a ball that the robot still holds
constexpr double kIncoming_mps = 1.8;
// Largest distance from the ball's path at which the robot steps onto it.
constexpr double kBesideLine_m = 0.7;
constexpr double kFrame_s = 1.0 / 60;

constexpr double kPress_mps = 0.25;  // forward speed that keeps the ball at the plate

constexpr double kStrikeLane_m = 30_mm;   // largest lateral offset of a ball straight ahead
constexpr double kNear_m = 0.35;          // within this distance, the robot moves with the ball
constexpr double kStrikeRunUp_m = 50_mm;  // gap between plate and ball before the final run
constexpr double kExact_m = 30_mm;        // allowed lateral offset at a restart
constexpr double kClearOfBall_m = 25_mm;
constexpr double kCommits_m = 20_mm;  // gap from which the robot can hardly avoid the ball
// The robot slows down within this distance of a ball that must not be moved.
constexpr double kCarefulFrom_m = 0.35;
constexpr double kCareful_mps = 1.2;
constexpr double kRun_mps = 0.7;  // speed at which the robot runs into the ball
constexpr double kRunBraking_mps2 = 3.0;

// The angular velocity follows a time-optimal braking curve. It is limited near the target, and to
// the rate at which the dribbler can hold the ball.
double turn_rate_radps(double error_rad, const Strike& strike) {
  const double rate = std::sqrt(2 * strike.turn_braking_radps2 * std::abs(error_rad));
  return std::copysign(std::min({rate, 12 * std::abs(error_rad), strike.turn_radps}), error_rad);
}

// The kick's speed over ground; a chip at 45 degrees uses part of the speed to gain height.
double ground_mps(const Strike& strike) {
  return strike.chip ? strike.kick_mps * std::sqrt(0.5) : strike.kick_mps;
}

// The robot kicks if the ball would go in the direction of `aim`, allowing for the turn within this
// frame.
void kick_if_aligned(const TrackedRobot& robot, const Vec2& ball_mps, const Vec2& aim,
                     const Strike& strike, RobotCommand& command) {
  if (strike.kick_mps <= 0) return;
  const double error_rad =
      std::abs(angle_between(kicked_mps(robot.heading, ground_mps(strike), ball_mps), aim));
  const double turn_rad = std::abs(robot.angular_velocity_radps) * kFrame_s / 2;
  if (error_rad > strike.tolerance_rad + 0.3 * turn_rad) return;
  command.kick_mps = strike.kick_mps;
  command.chip = strike.chip;
}

RobotCommand turn_and_kick(const TrackedRobot& robot, const Vec2& aim, const Strike& strike) {
  RobotCommand command;
  command.velocity_mps = Vec2(kPress_mps, 0);
  const Vec2 heading = kick_heading(aim, ground_mps(strike), robot.velocity_mps);
  command.angular_velocity_radps = turn_rate_radps(angle_between(robot.heading, heading), strike);
  command.dribble = true;
  kick_if_aligned(robot, plate_mps(robot), aim, strike, command);
  return command;
}

// The robot stands in the ball's path. It kicks the ball first-time if the angle allows this;
// otherwise, it stops the ball.
RobotCommand intercept_pass(const TrackedRobot& robot, const BallPath& path,
                            const BallInterception& interception, const Strike& strike,
                            const Vec2& aim, const Obstacles& obstacles,
                            const DrivingStyle& style) {
  const Vec2 back = -path.direction();
  const bool sends_on = strike.first_touch && aim.dot(back) > kWideFirstTouch;
  const Vec2 heading = sends_on ? kick_heading(aim, ground_mps(strike), path.velocity_mps()) : back;
  const Vec2 front_m = robot.position_m + heading * kStrikeTouch_m;
  // If the robot is already on the ball's path, it stays there; otherwise it goes to the earliest
  // interception.
  const double to_front_m = (front_m - path.now_m()).dot(path.direction());
  const double to_interception_m = (interception.point_m - path.now_m()).dot(path.direction());
  const double aside_m = std::abs(cross(path.direction(), front_m - path.now_m()));
  const double along_m =
      aside_m < 0.15 ? std::max(to_front_m, 0.0) : std::max(to_interception_m, 0.0);
  const Vec2 stand_m = path.now_m() + path.direction() * along_m - heading * kStrikeTouch_m;
  RobotCommand command =
      drive_via(robot, steer_for(robot, stand_m, obstacles), {stand_m, heading}, style);
  command.dribble = true;
  if (sends_on) kick_if_aligned(robot, path.velocity_mps(), aim, strike, command);
  return command;
}

RobotCommand fetch(const TrackedRobot& robot, const BallPath& path,
                   const BallInterception& interception, const Strike& strike, const Vec2& aim,
                   const Obstacles& obstacles, const DrivingStyle& style) {
  const bool is_near = (path.now_m() - robot.position_m).norm() < kNear_m;
  const Vec2& ball_m = is_near ? path.now_m() : interception.point_m;
  const Vec2 to_ball = ball_m - robot.position_m;
  const Vec2 straight = direction_of(to_ball, aim);
  // The approach direction lies between the straight path and the aim. The larger the bend, the
  // less the robot has to turn with the ball.
  const double bend_rad =
      std::clamp(angle_between(straight, aim), -strike.bend_rad, strike.bend_rad);
  Vec2 from = to_world(heading_of(bend_rad), straight);  // direction through the ball
  // Removes the component that would push the ball out of the field.
  const double outwards = from.dot(strike.keep_off);
  if (outwards > 0) from = direction_of(from - strike.keep_off * outwards, aim);
  const double ahead_m = to_ball.dot(from) - kStrikeTouch_m;
  const double aside_m = cross(from, to_ball);
  RobotCommand command;
  if (is_near) {  // the robot moves with the ball, and into it once the ball is straight ahead
    const bool in_lane = std::abs(aside_m) < kStrikeLane_m + 0.25 * std::max(0.0, ahead_m);
    const double left_m = ahead_m - (in_lane ? 0.0 : kStrikeRunUp_m);
    const double run_mps = in_lane
                               ? kRun_mps + std::sqrt(2 * kRunBraking_mps2 * std::max(0.0, left_m))
                               : style.approach_per_s * left_m;
    const Vec2 velocity_mps =
        path.velocity_mps() + from * run_mps + left_of(from) * (style.approach_per_s * aside_m);
    command = drive_with(robot, clamp_norm(velocity_mps, style.speed_mps), from, style);
  } else {
    const Vec2 stand_m = ball_m - from * (kStrikeTouch_m + kStrikeRunUp_m / 2);
    command = drive_via(robot, steer_for(robot, stand_m, obstacles), {stand_m, from}, style);
  }
  command.dribble = true;
  kick_if_aligned(robot, path.velocity_mps(), aim, strike, command);
  return command;
}

}  // namespace

Vec2 plate_mps(const TrackedRobot& robot) {
  return robot.velocity_mps +
         left_of(robot.heading) * (robot.angular_velocity_radps * kStrikeTouch_m);
}

Vec2 kicked_mps(const Vec2& heading, double along_mps, const Vec2& ball_mps) {
  const Vec2 across = left_of(heading);
  return heading * along_mps + across * ball_mps.dot(across);
}

// Let t be the tangent of the angle between heading and aim, a the ball's speed along the aim, c
// its speed across it and v the kick's speed. Then the ball has no motion across the aim if v t
// sqrt(1 + t^2) = c + a t. This is solved by fixed-point iteration, for headings at most 45 degrees
// off the aim.
Vec2 kick_heading(const Vec2& aim, double along_mps, const Vec2& ball_mps) {
  if (along_mps <= 0) return aim;
  const double along = ball_mps.dot(aim);
  const double across = ball_mps.dot(left_of(aim));
  double tangent = 0;
  for (int i = 0; i < 4; ++i) {
    const double per_tangent = along_mps * std::sqrt(1 + square(tangent)) - along;
    tangent = std::clamp(across / std::max(per_tangent, 0.2 * along_mps), -1.0, 1.0);
  }
  return direction_of(aim - left_of(aim) * tangent, aim);
}

RobotCommand take_kick(const TrackedRobot& robot, const Vec2& ball_m, const Strike& strike,
                       const Obstacles& obstacles, const DrivingStyle& style) {
  const Vec2 aim = direction_of(strike.target_m - ball_m, robot.heading);
  const Vec2 to_ball = ball_m - robot.position_m;
  const double ahead_m = to_ball.dot(aim) - kStrikeTouch_m;
  const double aside_m = cross(aim, to_ball);
  const bool is_behind = ahead_m > -kStrikeTouch_m / 2 && ahead_m < 0.4;
  if (is_behind && std::abs(aside_m) < kExact_m + 0.3 * std::max(0.0, ahead_m - kStrikeRunUp_m)) {
    const bool is_at_ball = ahead_m < kCommits_m;
    const double tolerance_rad =
        is_at_ball ? std::max(strike.tolerance_rad, strike.commit_rad) : strike.tolerance_rad;
    const bool is_aligned =
        std::abs(angle_between(robot.heading, aim)) < tolerance_rad && std::abs(aside_m) < kExact_m;
    // The robot drives up to the ball, and into it once it is aligned.
    const double left_m = ahead_m - (is_aligned ? 0.0 : kClearOfBall_m);
    const double run_mps = (is_aligned ? kRun_mps : 0.0) + style.approach_per_s * left_m;
    RobotCommand command = drive_with(
        robot, aim * run_mps + left_of(aim) * (style.approach_per_s * aside_m), aim, style);
    if (is_aligned) command.kick_mps = strike.kick_mps;
    command.chip = strike.chip;
    command.dribble = strike.dribble;
    return command;
  }
  const Vec2 stand_m = ball_m - aim * (kStrikeTouch_m + kStrikeRunUp_m + kBallRadius_m);
  Obstacles all = obstacles;
  all.push_back({ball_m, kRobotRadius_m + kBallRadius_m + kClearOfBall_m});
  DrivingStyle careful = style;
  if (to_ball.norm() < kCarefulFrom_m) careful.speed_mps = std::min(kCareful_mps, style.speed_mps);
  return drive_via(robot, steer_for(robot, stand_m, all), {stand_m, aim}, careful);
}

bool has_ball(const TrackedRobot& robot, const Vec2& ball_m) {
  const Vec2 local_m = to_local(ball_m - robot.position_m, robot.heading);
  return local_m.x() > kFrontDistance_m - 10_mm &&
         local_m.x() < kStrikeTouch_m + kInDribblerZone_m &&
         std::abs(local_m.y()) < kDribblerZoneWidth_m / 2;
}

bool comes_towards(const TrackedRobot& robot, const BallPath& path) {
  if (path.speed_mps() < kIncoming_mps) return false;
  const Vec2 to_robot = robot.position_m - path.now_m();
  return to_robot.dot(path.direction()) > kFrontDistance_m &&
         std::abs(cross(path.direction(), to_robot)) < kBesideLine_m;
}

RobotCommand strike_ball(const TrackedRobot& robot, const BallPath& path,
                         const BallInterception& interception, const Strike& strike,
                         const Obstacles& obstacles, const DrivingStyle& style) {
  const bool holds = has_ball(robot, path.now_m());
  const Vec2& from_m = holds ? path.now_m() : interception.point_m;
  const Vec2 aim = direction_of(strike.target_m - from_m, robot.heading);
  if (holds) return turn_and_kick(robot, aim, strike);
  if (comes_towards(robot, path))
    return intercept_pass(robot, path, interception, strike, aim, obstacles, style);
  return fetch(robot, path, interception, strike, aim, obstacles, style);
}

RobotCommand carry_ball(const TrackedRobot& robot, const Vec2& velocity_mps, const Vec2& heading,
                        const Strike& strike) {
  RobotCommand command;
  command.velocity_mps = to_local(velocity_mps, robot.heading);
  command.angular_velocity_radps = turn_rate_radps(angle_between(robot.heading, heading), strike);
  command.dribble = true;
  return command;
}

}  // namespace autoref::strategies
