#include "sim/dribbler.hpp"

#include "sim/dribbler_zone.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::sim {
namespace {

// Fraction of the distance to the centre that a held ball is moved per sub-step.
constexpr double kCentringShare = 0.25;

// From the ball to its resting position at the plate's centre.
Vec2 path_to_rest_m(const BodyState& robot, const Vec2& arm_m) {
  return robot.heading * (kFrontDistance_m + kBallRadius_m) - arm_m;
}

// Spring and damper. The damper acts on the motion relative to the turning robot, whose velocity at
// the ball is v + omega x r.
Vec2 pull_n(const DribblerParameters& parameters, const BodyState& robot, const BodyState& ball) {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 there_mps = robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m);
  return parameters.stiffness_npm * path_to_rest_m(robot, arm_m) +
         parameters.damping_nspm * (there_mps - ball.velocity_mps);
}

// The force that gives the ball the plate's velocity within this sub-step (deadbeat control), plus
// a slow drift to the centre. The plate moves along an arc; the ball follows its chord.
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

}  // namespace autoref::sim
