// Place, velocity and acceleration of what speeds up or slows down evenly, by some detections:
// least squares, all weighted by their variances. Both coordinates share one covariance.
#pragma once

#include <Eigen/Core>

#include "soccer/geometry.hpp"

namespace autoref::referee {

// At the time 0.
struct ConstantAcceleration {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  Vec2 acceleration_mps2{0, 0};
  double velocity_deviation_mps = 0;  // standard deviation of each coordinate

  Vec2 position_after(double duration_s) const {
    return position_m + duration_s * velocity_mps + duration_s * duration_s / 2 * acceleration_mps2;
  }
  Vec2 velocity_after(double duration_s) const {
    return velocity_mps + duration_s * acceleration_mps2;
  }
};

class ConstantAccelerationFit {
 public:
  // What is known of the acceleration beforehand, and its standard deviation in each coordinate.
  ConstantAccelerationFit(const Vec2& acceleration_mps2, double deviation_mps2);

  // Where it was at that time. `deviation_m`, of each coordinate, must be above 0.
  void add(double time_s, const Vec2& position_m, double deviation_m);

  // Needs two detections of different times.
  ConstantAcceleration motion() const;

 private:
  Eigen::Matrix3d weights_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> sums_ = Eigen::Matrix<double, 3, 2>::Zero();
};

}  // namespace autoref::referee
