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

// A dribbler that gets the ball back this soon continues its grip.
constexpr double kPauseInGrip_s = 100_ms;

// A grip has at least this fraction of the maximum force.
constexpr double kLeastGrip = 0.1;

// The vector from the ball to its resting position at the plate's centre.
Vec2 path_to_rest_m(const BodyState& robot, const Vec2& arm_m) {
  return robot.heading * (kFrontDistance_m + kBallRadius_m) - arm_m;
}

// The 1e-9 absorbs rounding, which could otherwise add a sub-step.
std::int64_t substeps_in(double duration_s, double substeps_per_s) {
  return static_cast<std::int64_t>(std::ceil(duration_s * substeps_per_s - 1e-9));
}

}  // namespace

Dribbler::Dribbler(const DribblerParameters& parameters, double ball_mass_kg, double substeps_per_s)
    : parameters_(parameters),
      ball_mass_kg_(ball_mass_kg),
      pause_substeps_(substeps_in(kPauseInGrip_s, substeps_per_s)),
      limit_n_(parameters.force_n) {}

Vec2 Dribbler::force_n(const BodyState& robot, const BodyState& ball, double ball_height_m,
                       double duration_s, std::int64_t substep, RandomStream& noise) {
  if (!is_in_dribbler_zone(robot, ball.position_m, ball_height_m, parameters_.reach_m))
    return {0.0, 0.0};
  if (parameters_.force_noise > 0.0 && substep >= grips_until_) {
    const double factor = 1.0 + parameters_.force_noise * noise.normal();
    limit_n_ = parameters_.force_n * std::max(kLeastGrip, factor);
  }
  grips_until_ = substep + pause_substeps_;
  return clamp_norm(parameters_.holds ? hold_n(robot, ball, duration_s) : pull_n(robot, ball),
                    limit_n_);
}

// The dribbler acts as spring and damper. The damper acts on the motion relative to the turning
// robot, whose velocity at the ball is v + omega x r.
Vec2 Dribbler::pull_n(const BodyState& robot, const BodyState& ball) const {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 there_mps = robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m);
  return parameters_.stiffness_npm * path_to_rest_m(robot, arm_m) +
         parameters_.damping_nspm * (there_mps - ball.velocity_mps);
}

// The force that gives the ball the plate's velocity within this sub-step (deadbeat control), plus
// a slow drift towards the centre. The plate moves along an arc; the ball follows its chord.
Vec2 Dribbler::hold_n(const BodyState& robot, const BodyState& ball, double duration_s) const {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 turned_m = to_world(arm_m, heading_of(robot.angular_velocity_radps * duration_s));
  const Vec2 there_mps = robot.velocity_mps + (turned_m - arm_m) / duration_s;
  const Vec2 centring_mps = clamp_norm(path_to_rest_m(robot, arm_m) * (kCentringShare / duration_s),
                                       parameters_.centring_mps);
  return (there_mps + centring_mps - ball.velocity_mps) * (ball_mass_kg_ / duration_s);
}

Kicker::Kicker(const KickerParameters& parameters, double substeps_per_s)
    : parameters_(parameters),
      dead_substeps_(substeps_in(parameters.dead_time_s, substeps_per_s)),
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
