// Least squares of a flight and of a way along the carpet through what vision reports: the sums
// that chip_flight.hpp compares. Detections weigh 1, so that a misfit, the sum of squared
// residuals, is chi-square times the variance of a reported coordinate. Places are relative to the
// kick's.
#pragma once

#include <Eigen/Cholesky>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref {

struct BallDetection {
  double time_s = 0;
  Vec2 reported_m{0, 0};  // on the plane of a lying ball's centre
  Vec2 camera_m{0, 0};
  double camera_height_m = 4;  // above that plane
};

// The ball is at reported - slant * height: the slope of the ray through a place on the carpet.
inline Vec2 slant_of(const Vec2& position_m, const BallDetection& seen) {
  return (position_m - seen.camera_m) / seen.camera_height_m;
}

// The unknowns of a flight at time 0: place (2), velocity (2), height, vertical speed.
using FlightRow = Eigen::Matrix<double, 6, 1>;

struct FlightSums {
  Eigen::Matrix<double, 6, 6> rows = Eigen::Matrix<double, 6, 6>::Zero();
  FlightRow values = FlightRow::Zero();
  double squares = 0;

  // The equation row * unknowns = value.
  void add(const FlightRow& row, double value, double weight);

  // The ball at that time is on the ray with that slant through the reported place.
  void add_detection(double t_s, const Vec2& reported_m, const Vec2& slant);
};

struct FlightFit {
  explicit FlightFit(const FlightSums& sums);

  Vec2 velocity_mps() const { return unknowns.segment<2>(2); }
  double rise_mps() const { return unknowns[5]; }
  double height_at(double t_s) const {
    return unknowns[4] + t_s * unknowns[5] - kGravity_mps2 / 2 * t_s * t_s;
  }
  double landing_mps() const {  // downwards; where the ball is ever up
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

  // Of the best straight way with a constant braking between 0 and 11 m/s²; it leads past the
  // kick's place, which counts with `position_weight`. At least three detections.
  double misfit(double position_weight) const;
};

}  // namespace autoref
