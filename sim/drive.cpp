#include "sim/drive.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {
namespace {

// The drive directions of wheels at these angles.
std::array<Vec2, 4> tangents_at(const std::array<double, 4>& angles_deg) {
  std::array<Vec2, 4> tangents;
  std::transform(angles_deg.begin(), angles_deg.end(), tangents.begin(),
                 [](double deg) { return left_of(heading_of(to_radians(deg))); });
  return tangents;
}

}  // namespace

Drive::Drive(const RobotSpec& spec)
    : wheel_distance_m_(spec.body.wheel_distance_m),
      mass_kg_(spec.body.mass_kg),
      inertia_kgm2_(robot_inertia_kgm2(spec.body.mass_kg)),
      speed_mps_(spec.body.speed_mps * spec.speed_factor),
      angular_speed_radps_(spec.body.angular_speed_radps),
      acceleration_mps2_(spec.body.acceleration_mps2 * spec.acceleration_factor),
      braking_mps2_(spec.body.braking_mps2 * spec.acceleration_factor),
      wheel_mps2_(spec.body.wheel_acceleration_mps2 * spec.acceleration_factor),
      angular_radps2_(spec.body.angular_acceleration_radps2),
      noise_(spec.body.speed_noise) {
  const RobotParameters& body = spec.body;
  const auto wheels = tangents_at(
      {body.front_wheels_deg, -body.front_wheels_deg, body.back_wheels_deg, -body.back_wheels_deg});
  for (int i = 0; i < 4; ++i) {
    wheels_x_[i] = wheels[static_cast<std::size_t>(i)].x();
    wheels_y_[i] = wheels[static_cast<std::size_t>(i)].y();
  }
}

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

// Deadbeat velocity control: it corrects the whole velocity error within this step, and the limits
// turn this into ramps of constant acceleration.
DriveForce Drive::force(const RobotCommand& aim, const BodyState& robot, double duration_s) const {
  const Vec2 now_mps = to_local(robot.velocity_mps, robot.heading);
  const Vec2 error_mps = aim.velocity_mps - now_mps;
  const bool slows_down = now_mps.dot(error_mps) < 0.0;
  const Vec2 change_mps =
      clamp_norm(error_mps, duration_s * (slows_down ? braking_mps2_ : acceleration_mps2_));
  const double most_radps = duration_s * angular_radps2_;
  const double change_radps = std::clamp(aim.angular_velocity_radps - robot.angular_velocity_radps,
                                         -most_radps, most_radps);
  const double share =
      share_within_wheels(change_mps, change_radps, duration_s * wheel_mps2_) / duration_s;
  return {to_world(change_mps * (mass_kg_ * share), robot.heading),
          change_radps * (inertia_kgm2_ * share)};
}

// Each row of the wheel matrix maps the motion to a wheel's rim speed. Scaling all four wheels
// equally scales the motion equally, so no pseudo-inverse is needed.
double Drive::share_within_wheels(const Vec2& change_mps, double change_radps,
                                  double limit_mps) const {
  const double most_mps =
      (wheels_x_ * change_mps.x() + wheels_y_ * change_mps.y() + wheel_distance_m_ * change_radps)
          .abs()
          .maxCoeff();
  return most_mps > limit_mps ? limit_mps / most_mps : 1.0;
}

}  // namespace autoref::sim
