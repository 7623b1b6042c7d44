#include "sim/kicker.hpp"

#include <algorithm>
#include <cmath>

#include "sim/mouth.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {

Kickers::Kickers(const KickerParameters& parameters, double substeps_per_s, RandomStream noise)
    : parameters_(parameters),
      dead_substeps_(
          static_cast<std::int64_t>(std::ceil(parameters.dead_time_s * substeps_per_s - 1e-9))),
      chip_sin_(sin_cos(to_radians(parameters.chip_angle_deg)).sin),
      chip_cos_(sin_cos(to_radians(parameters.chip_angle_deg)).cos),
      noise_(noise) {}

std::optional<Kick> Kickers::fire(int number, const RobotCommand& order, const BodyState& robot,
                                  const Vec2& ball_m, double ball_height_m, std::int64_t substep) {
  std::int64_t& ready_at = ready_at_[static_cast<std::size_t>(number)];
  if (order.kick_mps <= 0.0 || substep < ready_at) return std::nullopt;
  if (!is_in_mouth(robot, ball_m, ball_height_m, parameters_.reach_m)) return std::nullopt;
  ready_at = substep + dead_substeps_;
  return make(order, robot.heading);
}

Kick Kickers::make(const RobotCommand& order, const Vec2& heading) {
  const double limit_mps = order.chip ? parameters_.chip_limit_mps : parameters_.speed_limit_mps;
  const double speed_factor = 1.0 + parameters_.speed_noise * noise_.normal();
  const double off_rad = to_radians(parameters_.direction_noise_deg) * noise_.normal();
  const double speed_mps = std::clamp(order.kick_mps * speed_factor, 0.0, limit_mps);
  const Vec2 direction = to_world(heading_of(off_rad), heading);
  if (!order.chip) return {direction * speed_mps, 0.0};
  return {direction * (speed_mps * chip_cos_), speed_mps * chip_sin_};
}

}  // namespace autoref::sim
