#include "sim/kicker.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::sim {
namespace {

// Fraction of the distance to the centre that a held ball is moved per sub-step.
constexpr double kCentringShare = 0.25;

// The vector from the ball to its resting position at the plate's centre.
Vec2 path_to_rest_m(const BodyState& robot, const Vec2& arm_m) {
  return robot.heading * (kFrontDistance_m + kBallRadius_m) - arm_m;
}

// The dribbler acts as spring and damper. The damper acts on the motion relative to the turning
// robot, whose velocity at the ball is v + omega x r.
Vec2 pull_n(const DribblerParameters& parameters, const BodyState& robot, const BodyState& ball) {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 there_mps = robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m);
  return parameters.stiffness_npm * path_to_rest_m(robot, arm_m) +
         parameters.damping_nspm * (there_mps - ball.velocity_mps);
}

// The force that gives the ball the plate's velocity within this sub-step (deadbeat control), plus
// a slow drift towards the centre. The plate moves along an arc; the ball follows its chord.
Vec2 hold_n(const DribblerParameters& parameters, const BodyState& robot, const BodyState& ball,
            double ball_mass_kg, double duration_s) {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 turned_m = to_world(arm_m, heading_of(robot.angular_velocity_radps * duration_s));
  const Vec2 there_mps = robot.velocity_mps + (turned_m - arm_m) / duration_s;
  const Vec2 centring_mps = clamp_norm(path_to_rest_m(robot, arm_m) * (kCentringShare / duration_s),
                                       parameters.centring_mps);
  return (there_mps + centring_mps - ball.velocity_mps) * (ball_mass_kg / duration_s);
}

}  // namespace

Vec2 dribbler_force_n(const DribblerParameters& parameters, const BodyState& robot,
                      const BodyState& ball, double ball_mass_kg, double ball_height_m,
                      double duration_s) {
  if (!is_in_dribbler_zone(robot, ball.position_m, ball_height_m, parameters.reach_m)) {
    return {0.0, 0.0};
  }
  return clamp_norm(parameters.holds ? hold_n(parameters, robot, ball, ball_mass_kg, duration_s)
                                     : pull_n(parameters, robot, ball),
                    parameters.force_n);
}

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

// A random number is drawn only if there is noise.
SinCos Kicker::chip_angle(RandomStream& noise) const {
  if (parameters_.chip_angle_noise_deg <= 0.0) return chip_angle_;
  const double angle_deg =
      parameters_.chip_angle_deg + parameters_.chip_angle_noise_deg * noise.normal();
  return sin_cos(to_radians(std::clamp(angle_deg, 5.0, 85.0)));
}

}  // namespace autoref::sim
