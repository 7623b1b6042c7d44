#include "logs/fit/bounces.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace autoref::logs {
namespace {

// The faster a bounce, the less noise matters, so it counts as the square of its speed up to this.
constexpr double kFullWeight_mps = 3.0;

}  // namespace

Bounce bounce_of(double closing_mps, double leaving_mps) {
  return {leaving_mps / closing_mps, square(std::min(closing_mps, kFullWeight_mps))};
}

Line straight_line_through(const Points& points) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 powers(1, points.times_s[i]);
    const double weight = 1 / square(points.deviations_m[i]);
    normal += weight * powers * powers.transpose();
    right += weight * powers * points.positions_m[i].transpose();
  }
  const Eigen::Matrix2d fitted = normal.inverse() * right;
  Line line{fitted.row(0).transpose(), fitted.row(1).transpose(), 0};
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += (points.positions_m[i] - line.at(points.times_s[i])).squaredNorm() /
           square(points.deviations_m[i]);
  line.residual = std::sqrt(sum / static_cast<double>(2 * points.size()));
  return line;
}

}  // namespace autoref::logs
