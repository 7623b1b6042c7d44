#include "referee/geometry/hull.hpp"

#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Noise exceeds this many standard deviations in one of several hundred frames.
constexpr double kHullDeviations = 3;

}  // namespace

double reach_of_hull_m(const Vec2& heading, const Vec2& direction) {
  // The support function of a disc cut by a flat front. In the directions in which the front cuts
  // off the circle, a corner of the front reaches farthest.
  const Vec2 local = to_local(direction, heading);
  if (local.x() * kRobotRadius_m < kFrontDistance_m) return kRobotRadius_m;
  return local.x() * kFrontDistance_m + std::abs(local.y()) * kHalfPlate_m;
}

double robot_uncertainty_m(const tracking::VisionNoise& noise) {
  return kHullDeviations * noise.robot_m;
}

double robot_to_ball_uncertainty_m(const tracking::VisionNoise& noise) {
  return kHullDeviations * std::hypot(noise.robot_m, noise.ball_m);
}

}  // namespace autoref::referee
