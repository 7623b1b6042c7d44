// Invariants of the ball's collisions with robots and walls, checked on the states before and after
// a sub-step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/world.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::sim {

inline constexpr double kSubstep_s = 1.0 / 240;

// Turns each sub-step of the default world into a frame, so that every sub-step can be inspected.
inline Configuration every_substep(Configuration configuration) {
  configuration.substeps = 1;
  configuration.frame_rate_hz = 240.0;
  return configuration;
}

// Distance to an axis-aligned box; negative inside.
inline double distance_to_box(const Vec2& point_m, const Vec2& low_m, const Vec2& high_m) {
  const Vec2 off_m = (low_m - point_m).cwiseMax(point_m - high_m);
  const double inside_m = std::min(0.0, off_m.maxCoeff());
  return off_m.cwiseMax(0.0).norm() + inside_m;
}

// Distance to the nearest outer wall, goal wall or goal back; negative inside a wall.
inline double distance_to_walls(const Field& field, const Vec2& point_m) {
  const Vec2 p_m(std::abs(point_m.x()), std::abs(point_m.y()));  // the four quarters are symmetric
  const double line = field.half_length_m();
  const double back = line + field.goal_depth_m;
  const double inner = field.half_goal_m();
  const double outer = inner + field.goal_wall_thickness_m;
  const double side_m = distance_to_box(p_m, {line, inner}, {back, outer});
  const double back_m =
      distance_to_box(p_m, {back, -outer}, {back + field.goal_wall_thickness_m, outer});
  return std::min({field.wall_x_m() - p_m.x(), field.wall_y_m() - p_m.y(), side_m, back_m});
}

inline double distance_to_robot(const RobotState& robot, const Vec2& point_m) {
  return distance_to_hull(point_m, robot.position_m, robot.heading);
}

// The robot after `time_s` at constant velocity.
inline RobotState moved_on(RobotState robot, double time_s) {
  robot.position_m += robot.velocity_mps * time_s;
  robot.heading = to_world(heading_of(robot.angular_velocity_radps * time_s), robot.heading);
  return robot;
}

// The ball's speed along `outwards`, relative to the robot's surface at `arm_m` from its centre.
inline double leaving_mps(const BallState& ball, const RobotState& robot, const Vec2& arm_m,
                          const Vec2& outwards) {
  const Vec2 surface_mps = robot.velocity_mps + robot.angular_velocity_radps * left_of(arm_m);
  return (ball.velocity_mps - surface_mps).dot(outwards);
}

// The gradient direction of `distance_m`, a function of a point.
template <typename Distance>
Vec2 outwards_at(const Vec2& point_m, Distance distance_m) {
  constexpr double kNear_m = 1e-6;
  const Vec2 x_m(kNear_m, 0);
  const Vec2 y_m(0, kNear_m);
  return direction_of({distance_m(point_m + x_m) - distance_m(point_m - x_m),
                       distance_m(point_m + y_m) - distance_m(point_m - y_m)},
                      {1, 0});
}

// The time within the sub-step at which `gap_m`, a function of time, first reaches zero; if it
// never does, the time of its minimum.
template <typename Gap>
double closing_time_s(Gap gap_m) {
  constexpr int kSamples = 16;
  double nearest_s = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    double late_s = kSubstep_s * k / kSamples;
    if (gap_m(late_s) < gap_m(nearest_s)) nearest_s = late_s;
    if (gap_m(late_s) > 0.0) continue;
    double early_s = std::max(0.0, late_s - kSubstep_s / kSamples);
    for (int i = 0; i < 20; ++i) {
      const double middle_s = (early_s + late_s) / 2;
      (gap_m(middle_s) > 0.0 ? early_s : late_s) = middle_s;
    }
    return late_s;
  }
  return nearest_s;
}

// The ball's speed along the outward normal before and after a sub-step with a collision.
struct Bounce {
  double before_mps = 0;  // negative while approaching
  double after_mps = 0;
};

inline Bounce bounce_off_robot(const BallState& former, const BallState& ball,
                               const RobotState& former_robot, const RobotState& robot) {
  const auto at_m = [&](double t_s) { return Vec2(former.position_m + former.velocity_mps * t_s); };
  const double meets_s = closing_time_s([&](double t_s) {
    return distance_to_robot(moved_on(former_robot, t_s), at_m(t_s)) - kBallRadius_m;
  });
  const RobotState met = moved_on(former_robot, meets_s);
  const Vec2 outwards = outwards_at(
      at_m(meets_s), [&met](const Vec2& point_m) { return distance_to_robot(met, point_m); });
  const Vec2 arm_m = at_m(meets_s) - kBallRadius_m * outwards - met.position_m;
  return {leaving_mps(former, former_robot, arm_m, outwards),
          leaving_mps(ball, robot, arm_m, outwards)};
}

inline Bounce bounce_off_walls(const Field& field, const BallState& former, const BallState& ball) {
  const auto at_m = [&](double t_s) { return Vec2(former.position_m + former.velocity_mps * t_s); };
  const double meets_s = closing_time_s(
      [&](double t_s) { return distance_to_walls(field, at_m(t_s)) - kBallRadius_m; });
  const Vec2 outwards = outwards_at(
      at_m(meets_s), [&field](const Vec2& point_m) { return distance_to_walls(field, point_m); });
  return {former.velocity_mps.dot(outwards), ball.velocity_mps.dot(outwards)};
}

// The maximum effect of a sub-step's forces on the speed at which the ball leaves a robot: drive,
// rotation at the plate's corner, carpet, and the pull of a running dribbler.
inline double forced_mps(const BallParameters& ball, const RobotSpec& robot, bool dribbles) {
  const RobotParameters& body = robot.body;
  const double pull_mps2 = dribbles ? robot.dribbler.force_n / ball.mass_kg : 0.0;
  return kSubstep_s * (body.braking_mps2 + body.angular_acceleration_radps2 * kRobotRadius_m +
                       ball.slide_mps2 + pull_mps2);
}

// The minimum of `distance_m`, a function of a point and of the fraction of the path to it, on the
// straight line between two positions of the ball's centre. A ball that bounced off a convex
// body in between stayed on one side of it, and so does the line.
template <typename Distance>
double least_on_path_m(const Vec2& from_m, const Vec2& to_m, Distance distance_m) {
  constexpr int kSamples = 8;
  double least_m = distance_m(from_m, 0.0);
  for (int k = 1; k <= kSamples; ++k) {
    const double share = static_cast<double>(k) / kSamples;
    least_m = std::min(least_m, distance_m(from_m + share * (to_m - from_m), share));
  }
  return least_m;
}

}  // namespace autoref::sim
