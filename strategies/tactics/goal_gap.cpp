#include "strategies/tactics/goal_gap.hpp"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr int kGoalLinePoints = 17;  // points of the goal line
constexpr double kBlock_m = kRobotRadius_m + kBallRadius_m;
constexpr double kNearest_m = 50_mm;    // robots nearer to the ball, along the field, are ignored
constexpr double kFarthest = 0.62;      // of the field's length: shots from farther away are rare
constexpr double kStrayCost_per_m = 1;  // in samples covered, per metre from the usual point
constexpr double kAimWidth_m = 0.15;    // points of the goal this near to the aim count more
constexpr double kAimWeight = 1.0;      // by this much at most

using Weights = std::array<double, kGoalLinePoints>;

double sample_y(const Field& field, int i) {
  return (field.half_goal_m() - kBallRadius_m) * (2.0 * i / (kGoalLinePoints - 1) - 1);
}

// Sets the weights of all points behind a robot to zero.
void shade(const Field& field, const Vec2& from_m, const Vec2& robot_m, Weights& open) {
  const double to_robot_m = from_m.x() - robot_m.x();
  if (to_robot_m < kNearest_m || robot_m.x() < -field.half_length_m()) return;
  // Similar triangles, as in openings.cpp.
  const double stretch = (from_m.x() + field.half_length_m()) / to_robot_m;
  const double slope = (robot_m.y() - from_m.y()) / to_robot_m;
  const double half_m = kBlock_m * stretch * std::sqrt(1 + slope * slope);
  const double middle_m = from_m.y() + (robot_m.y() - from_m.y()) * stretch;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    if (std::abs(sample_y(field, i) - middle_m) < half_m) open[static_cast<std::size_t>(i)] = 0;
  }
}

Weights open_points(const PredictedState& predicted, const KeeperShadow& keeper) {
  Weights open;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    double& weight = open[static_cast<std::size_t>(i)];
    weight = 1;
    if (!keeper.aim_y_m) continue;
    const double near =
        1 - std::abs(sample_y(predicted.field(), i) - *keeper.aim_y_m) / kAimWidth_m;
    weight += kAimWeight * std::max(0.0, near);
  }
  for (int i = 1; i < predicted.robots(); ++i)
    shade(predicted.field(), predicted.threat_m(), predicted.robot(i).position_m, open);
  return open;
}

// An open point of the goal line.
struct OpenPoint {
  double y_m;
  double weight;
};
using OpenPoints = boost::container::static_vector<OpenPoint, kGoalLinePoints>;

OpenPoints without_shaded(const Field& field, const Weights& open) {
  OpenPoints points;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    const double weight = open[static_cast<std::size_t>(i)];
    if (weight > 0) points.push_back({sample_y(field, i), weight});
  }
  return points;
}

// What a shadow around `middle_m` covers: its middle surely, its ends hardly.
double covered(const OpenPoints& open, double middle_m, double half_width_m) {
  double sum = 0;
  for (const OpenPoint& point : open) {
    const double off_m = point.y_m - middle_m;
    if (std::abs(off_m) >= half_width_m) continue;
    const double off = off_m / half_width_m;
    sum += point.weight * std::max(0.0, 1 - off * off);
  }
  return sum;
}

}  // namespace

std::optional<double> gap_for_keeper_m(const PredictedState& predicted,
                                       const KeeperShadow& keeper) {
  const Field& field = predicted.field();
  const double ahead_m = predicted.threat_m().x() + field.half_length_m();
  if (ahead_m < 2 * kNearest_m || ahead_m > kFarthest * field.length_m) return std::nullopt;
  const OpenPoints open = without_shaded(field, open_points(predicted, keeper));
  if (open.empty()) return std::nullopt;
  std::array<double, kGoalLinePoints> cover{};
  int best = 0;
  for (int i = 0; i < kGoalLinePoints; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double y_m = sample_y(field, i);
    cover[at] = covered(open, y_m, keeper.half_width_m);
    if (cover[at] > 0) cover[at] -= kStrayCost_per_m * std::abs(y_m - keeper.usual_y_m);
    if (cover[at] > cover[static_cast<std::size_t>(best)]) best = i;
  }
  const auto at = static_cast<std::size_t>(best);
  if (cover[at] <= 0) return std::nullopt;
  if (best == 0 || best == kGoalLinePoints - 1) return sample_y(field, best);
  // The vertex of the parabola through the best sample and its neighbours.
  const double bend = cover[at - 1] - 2 * cover[at] + cover[at + 1];
  const double shift = bend < 0 ? (cover[at - 1] - cover[at + 1]) / (2 * bend) : 0.0;
  const double step_m = sample_y(field, 1) - sample_y(field, 0);
  return sample_y(field, best) + std::clamp(shift, -0.5, 0.5) * step_m;
}

}  // namespace autoref::strategies
