// Constant-velocity Kalman filter with white-noise acceleration.
#pragma once

#include <Eigen/Core>

namespace autoref::tracking {

// Measurement noise and process noise.
struct MotionNoise {
  double detection = 0;  // standard deviation of one coordinate of a detection; m or rad
  double process_noise_density = 0;  // growth rate of the velocity variance; m2/s3 or rad2/s3
  double any_change = 0;             // prior standard deviation of an unknown velocity
};

// Position and velocity along `Axes` identical axes, which share one covariance.
template <int Axes>
class MotionFilter {
 public:
  using Axis = Eigen::Matrix<double, 1, Axes>;

  explicit MotionFilter(const MotionNoise& noise) : noise_(noise) {}

  // Starts at a detection, with a velocity of 0 and its prior variance.
  void start(const Axis& seen) {
    motion_.row(0) = seen;
    motion_.row(1).setZero();
    position_variance_ = noise_.detection * noise_.detection;
    covariance_ = 0;
    speed_variance_ = noise_.any_change * noise_.any_change;
  }

  // Predicts the state `duration_s` ahead. `acceleration` is the known part of the acceleration.
  // The covariance grows by the discretised white-noise acceleration, q [t³/3, t²/2; t²/2, t].
  void predict(double duration_s, const Axis& acceleration) {
    const double t = duration_s;
    motion_.row(0) += t * motion_.row(1) + (t * t / 2) * acceleration;
    motion_.row(1) += t * acceleration;
    position_variance_ +=
        t * (2 * covariance_ + t * speed_variance_) + noise_.process_noise_density * t * t * t / 3;
    covariance_ += t * speed_variance_ + noise_.process_noise_density * t * t / 2;
    speed_variance_ += noise_.process_noise_density * t;
  }

  // Accounts for an arbitrary change of velocity that happened `duration_s` ago.
  void inflate_velocity_covariance(double duration_s) {
    const double variance = noise_.any_change * noise_.any_change;
    position_variance_ += variance * duration_s * duration_s;
    covariance_ += variance * duration_s;
    speed_variance_ += variance;
  }

  // The normalised innovation squared. It is chi-square distributed for a consistent filter, with
  // one degree of freedom per axis.
  double normalised_innovation_squared(const Axis& innovation) const {
    return innovation.squaredNorm() / innovation_variance();
  }

  // Corrects the state. `innovation` is the detection minus the prediction.
  void correct(const Axis& innovation) {
    const double position_gain = position_variance_ / innovation_variance();
    const double speed_gain = covariance_ / innovation_variance();
    motion_.row(0) += position_gain * innovation;
    motion_.row(1) += speed_gain * innovation;
    speed_variance_ -= speed_gain * covariance_;
    covariance_ -= position_gain * covariance_;
    position_variance_ -= position_gain * position_variance_;
  }

  Axis position() const { return motion_.row(0); }
  Axis velocity() const { return motion_.row(1); }
  void set_position(const Axis& position) { motion_.row(0) = position; }
  void set_velocity(const Axis& velocity) { motion_.row(1) = velocity; }

 private:
  double innovation_variance() const {
    return position_variance_ + noise_.detection * noise_.detection;
  }

  MotionNoise noise_;
  Eigen::Matrix<double, 2, Axes> motion_ = Eigen::Matrix<double, 2, Axes>::Zero();
  double position_variance_ = 0;
  double speed_variance_ = 0;
  double covariance_ = 0;  // covariance of position and velocity
};

}  // namespace autoref::tracking
