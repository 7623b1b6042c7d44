#include "tests/referee/rules/staged_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr double kGap_m = 1_mm;
constexpr double kCarriedGap_m = 0.5_mm;
constexpr double kReach_m = 5_mm;        // a kicker farther from the ball is an error in the case
constexpr double kRestitution = 0.5;     // between ball and robot
constexpr double kGroundBounce = 0.5;    // fraction of the vertical speed kept at a bounce
constexpr double kRollsBelow_mps = 0.3;  // upwards speed at which the ball stops bouncing
constexpr double kSliding_mps2 = 3.5;    // 3.0 to 3.9 on the league's carpets
constexpr double kRollingShare =
    5.0 / 7;  // fraction of the kick speed at which the ball begins to roll
constexpr int kSubsteps = 8;

Vec2 rotated(const Vec2& v, double angle_rad) { return to_world(v, heading_of(angle_rad)); }

// Outward normal of the hull.
Vec2 normal_at(const Vec2& point_m, const Vec2& centre_m, const Vec2& heading) {
  constexpr double kStep_m = 1e-5;
  const auto gap = [&](const Vec2& p) { return distance_to_hull(p, centre_m, heading); };
  const Vec2 x(kStep_m, 0);
  const Vec2 y(0, kStep_m);
  const Vec2 slope(gap(point_m + x) - gap(point_m - x), gap(point_m + y) - gap(point_m - y));
  return direction_of(slope, heading);
}

}  // namespace

void StagedBodies::put_behind_ball(const RobotId& id, const Vec2& heading) {
  put(id, ball_.at_m - heading * (kFrontDistance_m + kBallRadius_m + kGap_m), heading);
}

void StagedBodies::put_ball(const Vec2& at_m) {
  ball_ = {at_m, Vec2(0, 0), 0, 0, ball_.is_seen, 0};
}

void StagedBodies::place_ball(const Vec2& to_m, double at_most_m) {
  carriers_.clear();
  put_ball(ball_.at_m + clamp_norm(to_m - ball_.at_m, at_most_m));
}

StagedBodies::Robot& StagedBodies::robot(const RobotId& id) {
  const auto found = robots_.find(id);
  if (found != robots_.end()) return found->second;
  throw std::runtime_error("no robot " + std::string(name_of(id.side)) + " " +
                           std::to_string(id.number));
}

Vec2 StagedBodies::plate_m(const Robot& robot, double gap_m) const {
  return robot.at_m + robot.heading * (kFrontDistance_m + kBallRadius_m + gap_m);
}

void StagedBodies::kick(const Cue& cue) {
  const Robot& kicker = robot(cue.robot);
  if ((ball_.at_m - plate_m(kicker, 0)).norm() > kReach_m) {
    throw std::runtime_error("the kicker is not at the ball");
  }
  carriers_.erase(cue.robot);
  const Vec2 elevation = heading_of(to_radians(cue.angle_deg));
  ball_.velocity_mps = kicker.heading * (cue.speed * elevation.x());
  ball_.upwards_mps = cue.speed * elevation.y();
  ball_.rolls_below_mps = cue.angle_deg == 0 ? cue.speed * kRollingShare : cue.speed;
}

void StagedBodies::obey(const Cue& cue) {
  switch (cue.kind) {
    case Cue::Kind::kDrive:
      robot(cue.robot).to_m = cue.target;
      robot(cue.robot).speed_mps = cue.speed;
      break;
    case Cue::Kind::kTurn:
      robot(cue.robot).towards = heading_of(to_radians(cue.angle_deg));
      robot(cue.robot).turn_radps = to_radians(cue.speed);
      break;
    case Cue::Kind::kKick:
      kick(cue);
      break;
    case Cue::Kind::kCarry:
      carriers_.insert(cue.robot);
      break;
    case Cue::Kind::kRoll:
      ball_.velocity_mps = cue.target;
      ball_.rolls_below_mps = cue.target.norm();
      break;
    case Cue::Kind::kRobotSeen:
      robot(cue.robot).is_seen = cue.on;
      break;
    case Cue::Kind::kBallSeen:
      ball_.is_seen = cue.on;
      break;
    case Cue::Kind::kRequest:
      break;  // no effect on the field
  }
}

void StagedBodies::advance(double duration_s) {
  for (int i = 0; i < kSubsteps; ++i) step(duration_s / kSubsteps);
}

void StagedBodies::step(double duration_s) {
  for (auto& [id, robot] : robots_) drive(robot, duration_s);
  fly(duration_s);
  for (const auto& [id, robot] : robots_) meet(id, robot);
}

void StagedBodies::drive(Robot& robot, double duration_s) const {
  const Vec2 step = clamp_norm(robot.to_m - robot.at_m, robot.speed_mps * duration_s);
  robot.at_m += step;
  robot.velocity_mps = step / duration_s;
  const double most_rad = robot.turn_radps * duration_s;
  const double left_rad = angle_between(robot.heading, robot.towards);
  robot.heading = rotated(robot.heading, std::clamp(left_rad, -most_rad, most_rad));
}

double StagedBodies::carpet_mps2(double speed_mps) const {
  return speed_mps > ball_.rolls_below_mps + 1e-9 ? kSliding_mps2 : deceleration_mps2_;
}

void StagedBodies::fly(double duration_s) {
  const bool flies = ball_.height_m > 0 || ball_.upwards_mps > 0;
  const double speed_mps = ball_.velocity_mps.norm();
  const double loss_mps = flies ? 0 : carpet_mps2(speed_mps) * duration_s;
  ball_.velocity_mps = clamp_norm(ball_.velocity_mps, std::max(0.0, speed_mps - loss_mps));
  ball_.at_m += ball_.velocity_mps * duration_s;
  if (!flies) return;
  ball_.upwards_mps -= kGravity_mps2 * duration_s;
  ball_.height_m += ball_.upwards_mps * duration_s;
  if (ball_.height_m > 0) return;
  ball_.height_m = 0;
  ball_.upwards_mps *= -kGroundBounce;
  if (ball_.upwards_mps < kRollsBelow_mps) ball_.upwards_mps = 0;
}

void StagedBodies::meet(const RobotId& id, const Robot& robot) {
  if (ball_.height_m > kRobotHeight_m) return;
  const double gap_m = distance_to_hull(ball_.at_m, robot.at_m, robot.heading) - kBallRadius_m;
  if (carriers_.count(id) > 0) {
    if (gap_m > kReach_m) return;
    ball_.at_m = plate_m(robot, kCarriedGap_m);
    ball_.velocity_mps = robot.velocity_mps;
    ball_.rolls_below_mps = ball_.velocity_mps.norm();
    return;
  }
  if (gap_m > 0) return;
  const Vec2 normal = normal_at(ball_.at_m, robot.at_m, robot.heading);
  ball_.at_m -= normal * gap_m;
  const double approach_mps = (robot.velocity_mps - ball_.velocity_mps).dot(normal);
  if (approach_mps <= 0) return;
  ball_.velocity_mps += normal * (approach_mps * (1 + kRestitution));
  ball_.rolls_below_mps = ball_.velocity_mps.norm();
}

Frame StagedBodies::look() const {
  Frame frame;
  for (const auto& [id, robot] : robots_) {
    if (!robot.is_seen) continue;
    frame.robots[id.side].push_back({id.number, robot.at_m, robot.heading});
  }
  if (ball_.is_seen) frame.ball = BallObservation{ball_.at_m, ball_.height_m};
  return frame;
}

}  // namespace autoref::referee
