#include "sim/dribbler.hpp"

#include "sim/mouth.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// The pull is at its limit from about 5 mm off the middle. Damping is near critical for a rolling
// ball, which resists as one and a half times its mass.
constexpr double kStiffness_npm = 90.0;
constexpr double kDamping_nspm = 5.0;

}  // namespace

Vec2 dribbler_force_n(const DribblerParameters& parameters, const BodyState& robot,
                      const BodyState& ball, double ball_height_m) {
  if (!is_in_mouth(robot, ball.position_m, ball_height_m, parameters.reach_m)) {
    return {0.0, 0.0};
  }
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 rest_m = robot.heading * (kFrontDistance_m + kBallRadius_m);
  const Vec2 there_mps = robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m);
  const Vec2 pull_n =
      kStiffness_npm * (rest_m - arm_m) + kDamping_nspm * (there_mps - ball.velocity_mps);
  return clamp_norm(pull_n, parameters.force_n);
}

}  // namespace autoref::sim
