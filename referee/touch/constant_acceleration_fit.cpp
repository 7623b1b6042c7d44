#include "referee/touch/constant_acceleration_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace autoref::referee {

ConstantAccelerationFit::ConstantAccelerationFit(const Vec2& acceleration_mps2,
                                                 double deviation_mps2) {
  const double weight = 1 / (deviation_mps2 * deviation_mps2);
  weights_(2, 2) = weight;
  sums_.row(2) = weight * acceleration_mps2.transpose();
}

void ConstantAccelerationFit::add(double time_s, const Vec2& position_m, double deviation_m) {
  const double weight = 1 / (deviation_m * deviation_m);
  const Eigen::Vector3d row(1, time_s, time_s * time_s / 2);
  weights_ += weight * row * row.transpose();
  sums_ += weight * row * position_m.transpose();
}

ConstantAcceleration ConstantAccelerationFit::motion() const {
  const Eigen::Matrix3d covariance = weights_.inverse();
  const Eigen::Matrix<double, 3, 2> fitted = covariance * sums_;
  return {fitted.row(0).transpose(), fitted.row(1).transpose(), fitted.row(2).transpose(),
          std::sqrt(std::max(0.0, covariance(1, 1)))};
}

}  // namespace autoref::referee
