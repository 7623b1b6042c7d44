// A Kalman filter for things that go on evenly but for accelerations nobody told it of.
#pragma once

#include <Eigen/Core>

namespace autoref {

// How much to trust what is seen, and how much the motion.
struct MotionNoise {
  double detection = 0;  // standard deviation of one coordinate of a detection; m or rad
  double process_noise_density =
      0;                  // how the velocity's variance grows with time; m2/s3 or rad2/s3
  double any_change = 0;  // standard deviation of a velocity about which nothing is known
};

// Position and velocity along `Axes` axes that are alike: they share one covariance.
template <int Axes>
class MotionFilter {
 public:
  using Axis = Eigen::Matrix<double, 1, Axes>;

  explicit MotionFilter(const MotionNoise& noise) : noise_(noise) {}

  // Begins at a detection, at rest, knowing nothing of the velocity.
  void start(const Axis& seen) {
    motion_.row(0) = seen;
    motion_.row(1).setZero();
    position_variance_ = noise_.detection * noise_.detection;
    covariance_ = 0;
    speed_variance_ = noise_.any_change * noise_.any_change;
  }

  // Goes on for `duration_s`, with the known part of the acceleration.
  void predict(double duration_s, const Axis& acceleration) {
    const double t = duration_s;
    motion_.row(0) += t * motion_.row(1) + (t * t / 2) * acceleration;
    motion_.row(1) += t * acceleration;
    position_variance_ +=
        t * (2 * covariance_ + t * speed_variance_) + noise_.process_noise_density * t * t * t / 3;
    covariance_ += t * speed_variance_ + noise_.process_noise_density * t * t / 2;
    speed_variance_ += noise_.process_noise_density * t;
  }

  // The velocity may have become any other at the beginning of the last `duration_s`.
  void inflate_velocity_covariance(double duration_s) {
    const double variance = noise_.any_change * noise_.any_change;
    position_variance_ += variance * duration_s * duration_s;
    covariance_ += variance * duration_s;
    speed_variance_ += variance;
  }

  // The square of a detection's distance from the prediction, in deviations: for a filter that is
  // right, chi-squared with as many degrees of freedom as there are axes.
  double normalised_innovation_squared(const Axis& innovation) const {
    return innovation.squaredNorm() / innovation_variance();
  }

  // Takes in a detection that was `innovation` beside the prediction.
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
  double covariance_ = 0;  // of place and speed
};

}  // namespace autoref
