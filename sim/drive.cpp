#include "sim/drive.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {
namespace {

Vec2 tangent_at(double angle_deg) { return left_of(heading_of(to_radians(angle_deg))); }

}  // namespace

Drive::Drive(const RobotSpec& spec)
    : wheels_{tangent_at(spec.body.front_wheels_deg), tangent_at(-spec.body.front_wheels_deg),
              tangent_at(spec.body.back_wheels_deg), tangent_at(-spec.body.back_wheels_deg)},
      wheel_distance_m_(spec.body.wheel_distance_m),
      mass_kg_(spec.body.mass_kg),
      inertia_kgm2_(robot_inertia_kgm2(spec.body.mass_kg)),
      speed_mps_(spec.body.speed_mps * spec.speed_factor),
      angular_speed_radps_(spec.body.angular_speed_radps),
      acceleration_mps2_(spec.body.acceleration_mps2 * spec.acceleration_factor),
      braking_mps2_(spec.body.braking_mps2 * spec.acceleration_factor),
      wheel_mps2_(spec.body.wheel_acceleration_mps2 * spec.acceleration_factor),
      angular_radps2_(spec.body.angular_acceleration_radps2),
      noise_(spec.body.speed_noise) {}

RobotCommand Drive::accept(const RobotCommand& command, RandomStream& noise) const {
  RobotCommand aim = command;
  if (noise_ > 0.0) {
    aim.velocity_mps.x() *= 1.0 + noise_ * noise.normal();
    aim.velocity_mps.y() *= 1.0 + noise_ * noise.normal();
    aim.angular_velocity_radps *= 1.0 + noise_ * noise.normal();
  }
  aim.velocity_mps = clamp_norm(aim.velocity_mps, speed_mps_);
  aim.angular_velocity_radps =
      std::clamp(aim.angular_velocity_radps, -angular_speed_radps_, angular_speed_radps_);
  return aim;
}

// Deadbeat velocity control: corrects the whole velocity error within this step; the limits turn
// this into ramps of constant acceleration.
DriveForce Drive::force(const RobotCommand& aim, const BodyState& robot, double duration_s) const {
  const Vec2 now_mps = to_local(robot.velocity_mps, robot.heading);
  const Vec2 change_mps = aim.velocity_mps - now_mps;
  const bool slows_down = now_mps.dot(change_mps) < 0.0;
  const Vec2 acceleration_mps2 =
      clamp_norm(change_mps / duration_s, slows_down ? braking_mps2_ : acceleration_mps2_);
  const double angular_radps2 =
      std::clamp((aim.angular_velocity_radps - robot.angular_velocity_radps) / duration_s,
                 -angular_radps2_, angular_radps2_);
  const double share = share_within_wheels(acceleration_mps2, angular_radps2);
  return {to_world(acceleration_mps2 * (mass_kg_ * share), robot.heading),
          angular_radps2 * (inertia_kgm2_ * share)};
}

// Each row of the wheel matrix maps the motion to a wheel's rim acceleration. Scaling all four
// wheels equally scales the motion equally, so no pseudo-inverse is needed.
double Drive::share_within_wheels(const Vec2& acceleration_mps2, double angular_radps2) const {
  double most_mps2 = 0.0;
  for (const Vec2& wheel : wheels_) {
    most_mps2 = std::max(
        most_mps2, std::abs(wheel.dot(acceleration_mps2) + wheel_distance_m_ * angular_radps2));
  }
  return most_mps2 > wheel_mps2_ ? wheel_mps2_ / most_mps2 : 1.0;
}

}  // namespace autoref::sim
