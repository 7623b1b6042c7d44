// The omni-wheel drive: from an order and the robot's motion to a limited force.
#pragma once

#include <array>

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/random.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::sim {

// What the drive does to a robot's body, in the field's frame.
struct DriveForce {
  Vec2 force_n{0, 0};
  double torque_nm = 0;
};

// The drive of one robot. It never writes a velocity: robots that push each other are weighed by
// their forces.
class Drive {
 public:
  explicit Drive(const RobotSpec& spec);

  // The speeds that `command` makes the robot aim at: limited, and off by the motors' noise.
  RobotCommand accept(const RobotCommand& command, RandomStream& noise) const;

  // The force that brings the robot to `aim` (in its own frame) within `duration_s`, or as near as
  // the limits let it: overall acceleration or braking, angular acceleration, and each wheel's
  // tangential acceleration. A wheel at its limit slows the whole motion down, so that the
  // direction is kept.
  DriveForce force(const RobotCommand& aim, const BodyState& robot, double duration_s) const;

 private:
  double share_within_wheels(const Vec2& acceleration_mps2, double angular_radps2) const;

  std::array<Vec2, 4> wheels_;  // the direction each drives in, in the robot's frame
  double wheel_distance_m_;     // from the centre
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
