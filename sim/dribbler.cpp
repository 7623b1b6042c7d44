#include "sim/dribbler.hpp"

#include "sim/mouth.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::sim {
namespace {

// The pull is at its limit from about 5 mm off the middle. Damping is near critical for a rolling
// ball, which resists as one and a half times its mass.
constexpr double kStiffness_npm = 90.0;
constexpr double kDamping_nspm = 5.0;

// How a ball that is held comes to the middle: a share of the way in each sub-step, not too fast.
constexpr double kCentringShare = 0.25;
constexpr double kCentring_mps = 0.2;

// From the ball to where it rests against the plate's middle.
Vec2 way_to_rest_m(const BodyState& robot, const Vec2& arm_m) {
  return robot.heading * (kFrontDistance_m + kBallRadius_m) - arm_m;
}

Vec2 pull_n(const BodyState& robot, const BodyState& ball) {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 there_mps = robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m);
  return kStiffness_npm * way_to_rest_m(robot, arm_m) +
         kDamping_nspm * (there_mps - ball.velocity_mps);
}

// In a sub-step the plate's place goes along an arc; the ball follows along its chord.
Vec2 hold_n(const BodyState& robot, const BodyState& ball, double duration_s) {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 turned_m = to_world(arm_m, heading_of(robot.angular_velocity_radps * duration_s));
  const Vec2 there_mps = robot.velocity_mps + (turned_m - arm_m) / duration_s;
  const Vec2 centring_mps =
      clamp_norm(way_to_rest_m(robot, arm_m) * (kCentringShare / duration_s), kCentring_mps);
  return (there_mps + centring_mps - ball.velocity_mps) * (kBallMass_kg / duration_s);
}

}  // namespace

Vec2 dribbler_force_n(const DribblerParameters& parameters, const BodyState& robot,
                      const BodyState& ball, double ball_height_m, double duration_s) {
  if (!is_in_mouth(robot, ball.position_m, ball_height_m, parameters.reach_m)) {
    return {0.0, 0.0};
  }
  return clamp_norm(parameters.holds ? hold_n(robot, ball, duration_s) : pull_n(robot, ball),
                    parameters.force_n);
}

}  // namespace autoref::sim
