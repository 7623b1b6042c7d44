#include "tracking/chip_fit.hpp"

#include <algorithm>

namespace autoref::tracking {
namespace {

// Sliding balls decelerate by 3 to 10.3 m/s2 in the league's models.
constexpr double kHardestBraking_mps2 = 11;

// Residual of a straight-line fit, with the normal equations solved by Cramer's rule.
double line_misfit(double n, double s1, double s2, const Vec2& values, double squares) {
  const double determinant = n * s2 - s1 * s1;
  const double a = (s2 * values[0] - s1 * values[1]) / determinant;
  const double b = (n * values[1] - s1 * values[0]) / determinant;
  return squares - a * values[0] - b * values[1];
}

// Residual of the parabola whose curvature is clamped to the allowed range: the unconstrained
// residual plus the penalty for moving the curvature. The penalty's weight is the last diagonal
// entry of the Cholesky factor, squared: the curvature's information once the other unknowns are
// eliminated (Schur complement).
double braking_misfit(const Eigen::Matrix3d& rows, const Eigen::Vector3d& values, double squares) {
  const Eigen::LLT<Eigen::Matrix3d> equations(rows);
  const Eigen::Vector3d fit = equations.solve(values);
  const double allowed = std::clamp(fit[2], -kHardestBraking_mps2 / 2, 0.0);
  const double certainty = square(equations.matrixLLT()(2, 2));
  return squares - fit.dot(values) + certainty * square(fit[2] - allowed);
}

}  // namespace

void FlightSums::add(const FlightRow& row, double value, double weight) {
  rows += (weight * row) * row.transpose();
  values += (weight * value) * row;
  squares += weight * value * value;
}

// position + slant * height = reported, linear in all unknowns; gravity's term is known.
void FlightSums::add_detection(double t_s, const Vec2& reported_m, const Vec2& slant) {
  const Vec2 value = reported_m + slant * (kGravity_mps2 / 2 * t_s * t_s);
  FlightRow row;
  row << 1, 0, t_s, 0, slant.x(), slant.x() * t_s;
  add(row, value.x(), 1);
  row << 0, 1, 0, t_s, slant.y(), slant.y() * t_s;
  add(row, value.y(), 1);
}

// Weighted least squares by the normal equations. The residual follows from the sums alone, so no
// detection is stored.
FlightFit::FlightFit(const FlightSums& sums)
    : equations(sums.rows),
      unknowns(equations.solve(sums.values)),
      misfit(sums.squares - unknowns.dot(sums.values)) {}

void CarpetSums::add_detection(double t_s, const Vec2& reported_m) {
  const Eigen::Vector3d row(1, t_s, t_s * t_s);
  rows += row * row.transpose();
  values += row * reported_m.transpose();
  squares += reported_m * reported_m.transpose();
}

namespace {

// Misfit of a path that is straight across `along`, and a parabola with bounded deceleration along
// it. Across, the kick's position counts with `position_weight`.
double path_misfit(const CarpetSums& sums, const Vec2& along, double position_weight) {
  const Vec2 across = left_of(along);
  return line_misfit(sums.rows(0, 0) + position_weight, sums.rows(0, 1), sums.rows(1, 1),
                     (sums.values * across).head<2>(), across.dot(sums.squares * across)) +
         braking_misfit(sums.rows, sums.values * along, along.dot(sums.squares * along));
}

}  // namespace

// The velocity of the path is the regression slope.
double CarpetSums::misfit(double position_weight, const Vec2& before_mps) const {
  const double determinant = rows(0, 0) * rows(1, 1) - rows(0, 1) * rows(0, 1);
  const Vec2 velocity_mps = (rows(0, 0) * values.row(1) - rows(0, 1) * values.row(0)) / determinant;
  const Vec2 along = direction_of(velocity_mps, Vec2(1, 0));
  const double straight = path_misfit(*this, along, position_weight);
  if (before_mps.isZero(0)) return straight;
  return std::min(straight, path_misfit(*this, direction_of(velocity_mps - before_mps, along), 0));
}

}  // namespace autoref::tracking
