// Position, velocity and acceleration of a body with constant acceleration, estimated from
// detections: weighted least squares with a Gaussian prior on the acceleration. Both coordinates
// share one covariance.
#pragma once

#include <Eigen/Core>

#include "soccer/geometry.hpp"

namespace autoref::referee {

// The estimated motion, at time 0.
struct ConstantAcceleration {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  Vec2 acceleration_mps2{0, 0};
  double velocity_deviation_mps = 0;  // standard deviation per coordinate

  Vec2 position_after(double duration_s) const {
    return position_m + duration_s * velocity_mps + duration_s * duration_s / 2 * acceleration_mps2;
  }
  Vec2 velocity_after(double duration_s) const {
    return velocity_mps + duration_s * acceleration_mps2;
  }
};

class ConstantAccelerationFit {
 public:
  // Prior mean of the acceleration, and its standard deviation per coordinate.
  ConstantAccelerationFit(const Vec2& acceleration_mps2, double deviation_mps2);

  // Adds a detection. `deviation_m` is the position's standard deviation per coordinate and must be
  // positive.
  void add(double time_s, const Vec2& position_m, double deviation_m);

  // Requires two detections at different times.
  ConstantAcceleration motion() const;

 private:
  Eigen::Matrix3d weights_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> sums_ = Eigen::Matrix<double, 3, 2>::Zero();
};

}  // namespace autoref::referee
