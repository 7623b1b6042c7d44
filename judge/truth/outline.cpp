#include "judge/truth/outline.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr int kPoints = 256;
constexpr double kInContact_m = 5_mm;

// Points of the round hull, cut off at the front plate, and the plate's corners.
using Outline = std::array<Vec2, kPoints + 2>;

Outline outline() {
  Outline points;
  for (int i = 0; i < kPoints; ++i) {
    Vec2 point = kRobotRadius_m * heading_of(2 * 3.14159265358979323846 * i / kPoints);
    point.x() = std::min(point.x(), kFrontDistance_m);
    points[static_cast<std::size_t>(i)] = point;
  }
  points[kPoints] = {kFrontDistance_m, kHalfPlate_m};
  points[kPoints + 1] = {kFrontDistance_m, -kHalfPlate_m};
  return points;
}

template <typename Distance>
Reach reach(const sim::RobotState& robot, const Distance& distance_m) {
  // Brute force over sampled points: independent of the referee's closed formulas.
  static const Outline kOutline = outline();
  Reach reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec2& point : kOutline) {
    const double m = distance_m(Vec2(robot.position_m + to_world(point, robot.heading)));
    reach.nearest_m = std::min(reach.nearest_m, m);
    reach.farthest_m = std::max(reach.farthest_m, m);
  }
  return reach;
}

}  // namespace

Reach reach_to_area(const Field& field, Side side, const sim::RobotState& robot) {
  // Far from the area a bound is enough.
  const double centre_m = distance_to_defence_area(field, side, robot.position_m);
  if (centre_m > 0.5) return {centre_m - kRobotRadius_m, centre_m + kRobotRadius_m};
  return reach(robot,
               [&](const Vec2& at_m) { return distance_to_defence_area(field, side, at_m); });
}

Reach reach_into_half(Side side, const sim::RobotState& robot) {
  return reach(robot, [side](const Vec2& at_m) { return goal_sign(side) * at_m.x(); });
}

double hull_to_ball_m(const sim::RobotState& robot, const sim::BallState& ball) {
  return distance_to_hull(ball.position_m, robot.position_m, robot.heading);
}

bool are_in_contact(const sim::RobotState& a, const sim::RobotState& b) {
  return (a.position_m - b.position_m).norm() < 2 * kRobotRadius_m + kInContact_m;
}

}  // namespace autoref::judge::ground_truth
