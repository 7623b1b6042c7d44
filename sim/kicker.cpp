#include "sim/kicker.hpp"

#include <algorithm>
#include <cmath>

#include "sim/dribbler_zone.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {

Kicker::Kicker(const KickerParameters& parameters, double substeps_per_s)
    : parameters_(parameters),
      // The 1e-9 absorbs rounding, which could otherwise add a sub-step.
      dead_substeps_(
          static_cast<std::int64_t>(std::ceil(parameters.dead_time_s * substeps_per_s - 1e-9))),
      chip_angle_(sin_cos(to_radians(parameters.chip_angle_deg))) {}

std::optional<Kick> Kicker::fire(const RobotCommand& command, const BodyState& robot,
                                 const BodyState& ball, double ball_height_m, std::int64_t substep,
                                 RandomStream& noise) {
  if (command.kick_mps <= 0.0 || is_recharging(substep)) return std::nullopt;
  if (!is_in_dribbler_zone(robot, ball.position_m, ball_height_m, parameters_.reach_m))
    return std::nullopt;
  ready_at_ = substep + dead_substeps_;
  Kick kick = make(command, robot.heading, noise);
  const Vec2 across = left_of(robot.heading);
  kick.velocity_mps += across * ball.velocity_mps.dot(across);
  return kick;
}

Kick Kicker::make(const RobotCommand& command, const Vec2& heading, RandomStream& noise) const {
  const double limit_mps = command.chip ? parameters_.chip_limit_mps : parameters_.speed_limit_mps;
  const double speed_factor = 1.0 + parameters_.speed_noise * noise.normal();
  const double off_rad = to_radians(parameters_.direction_noise_deg) * noise.normal();
  const double speed_mps = std::clamp(command.kick_mps * speed_factor, 0.0, limit_mps);
  const Vec2 direction = to_world(heading_of(off_rad), heading);
  if (!command.chip) return {direction * speed_mps, 0.0};
  const SinCos angle = chip_angle(noise);
  return {direction * (speed_mps * angle.cos), speed_mps * angle.sin};
}

// Draws a number only if there is noise.
SinCos Kicker::chip_angle(RandomStream& noise) const {
  if (parameters_.chip_angle_noise_deg <= 0.0) return chip_angle_;
  const double angle_deg =
      parameters_.chip_angle_deg + parameters_.chip_angle_noise_deg * noise.normal();
  return sin_cos(to_radians(std::clamp(angle_deg, 5.0, 85.0)));
}

}  // namespace autoref::sim
