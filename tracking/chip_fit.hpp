// Least-squares fits of a ballistic flight and of a path on the carpet to what vision reports: the
// accumulated normal equations that chip_flight.hpp compares. Detections have weight 1, so a
// misfit, the sum of squared residuals, is chi-square times the variance of a reported coordinate.
// Positions are relative to the kick's.
#pragma once

#include <Eigen/Cholesky>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref::tracking {

struct BallDetection {
  double time_s = 0;
  Vec2 reported_m{0, 0};  // on the plane through the centre of a ball on the carpet
  Vec2 camera_m{0, 0};
  double camera_height_m = 4;  // above that plane
};

// Slope of the ray through a point on the carpet: the ball is at reported - slant * height.
inline Vec2 slant_of(const Vec2& position_m, const BallDetection& seen) {
  return (position_m - seen.camera_m) / seen.camera_height_m;
}

// The unknowns of a flight at time 0: position (2), velocity (2), height, vertical speed.
using FlightRow = Eigen::Matrix<double, 6, 1>;

struct FlightSums {
  Eigen::Matrix<double, 6, 6> rows = Eigen::Matrix<double, 6, 6>::Zero();
  FlightRow values = FlightRow::Zero();
  double squares = 0;

  // Adds the equation row * unknowns = value.
  void add(const FlightRow& row, double value, double weight);

  // Adds the equations for a ball on the ray with that slant through the reported position.
  void add_detection(double t_s, const Vec2& reported_m, const Vec2& slant);
};

struct FlightFit {
  explicit FlightFit(const FlightSums& sums);

  Vec2 velocity_mps() const { return unknowns.segment<2>(2); }
  double rise_mps() const { return unknowns[5]; }
  double height_at(double t_s) const {
    return unknowns[4] + t_s * unknowns[5] - kGravity_mps2 / 2 * t_s * t_s;
  }
  double landing_mps() const {  // downwards; only if the flight ever rises above the carpet
    return std::sqrt(unknowns[5] * unknowns[5] + 2 * kGravity_mps2 * unknowns[4]);
  }
  double landing_s() const { return (unknowns[5] + landing_mps()) / kGravity_mps2; }
  Vec2 position_at(double t_s) const { return unknowns.head<2>() + t_s * unknowns.segment<2>(2); }

  Eigen::LLT<Eigen::Matrix<double, 6, 6>> equations;
  FlightRow unknowns;
  double misfit;
};

struct CarpetSums {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> values = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();

  void add_detection(double t_s, const Vec2& reported_m);

  // Misfit of the best path on the carpet with a constant acceleration of at most 11 m/s2: a
  // straight one with a deceleration, through the kick's position, which counts with
  // `position_weight`; or a curved one. A ball slides until its spin matches its velocity. If it
  // rolled at `before_mps`, it keeps that spin at first, so the carpet accelerates it against the
  // change of its velocity, which need not be along its path. Needs at least three detections.
  double misfit(double position_weight, const Vec2& before_mps) const;
};

}  // namespace autoref::tracking
