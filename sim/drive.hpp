// The omni-wheel drive: computes a limited force from a command and the robot's motion.
#pragma once

#include <array>

#include "sim/box2d_bridge.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::sim {

// Force and torque that the drive exerts on a robot's body, in field coordinates.
struct DriveForce {
  Vec2 force_n{0, 0};
  double torque_nm = 0;
};

// The drive of one robot. It only applies forces and never sets a velocity, so the outcome of a
// pushing contest depends on the robots' forces.
class Drive {
 public:
  explicit Drive(const RobotSpec& spec);

  // The target velocity for `command`, limited to what the robot can do and with motor noise added.
  RobotCommand accept(const RobotCommand& command, RandomStream& noise) const;

  // The force that brings the robot to the velocity `aim` (in its own frame) within `duration_s`,
  // or as close to it as the limits allow. The limits apply to overall acceleration or braking,
  // angular acceleration, and each wheel's tangential acceleration. If a wheel reaches its limit,
  // the whole acceleration is scaled down, which preserves its direction.
  DriveForce force(const RobotCommand& aim, const BodyState& robot, double duration_s) const;

 private:
  // The fraction of a change of motion that the wheels can make if each may change its rim speed by
  // at most `limit_mps`.
  double share_within_wheels(const Vec2& change_mps, double change_radps, double limit_mps) const;

  Eigen::Array4d wheels_x_;  // drive direction of each wheel, in the robot's frame
  Eigen::Array4d wheels_y_;
  double wheel_distance_m_;  // distance of the wheels from the robot's centre
  double mass_kg_;
  double inertia_kgm2_;
  double speed_mps_;
  double angular_speed_radps_;
  double acceleration_mps2_;
  double braking_mps2_;
  double wheel_mps2_;
  double angular_radps2_;
  double noise_;
};

}  // namespace autoref::sim
