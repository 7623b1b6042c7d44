#include "referee/touch/ball_motion_filter.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::referee {
namespace {

constexpr double kAnySpeed_mps = 4.0;  // prior standard deviation of an unknown velocity
constexpr double kMillimetre2 = 1e-6;

// The series of 2 artanh(z), accurate to 1e-7. It is used because the last bit of the C library's
// logarithm differs between machines.
double natural_log(double x) {
  constexpr double kLog2 = 0.69314718055994531;
  int exponent = 0;
  const double part = std::frexp(x, &exponent);  // from 0.5 to 1
  const double z = (part - 0.75) / (part + 0.75);
  constexpr double kLogOfThreeQuarters = -0.28768207245178090;
  const double z2 = z * z;
  const double series = 1 + z2 * (1.0 / 3 + z2 * (1.0 / 5 + z2 * (1.0 / 7)));
  return exponent * kLog2 + kLogOfThreeQuarters + 2 * z * series;
}

}  // namespace

void BallMotionFilter::start(const Vec2& seen_m, const BallMotionParameters& parameters) {
  *this = BallMotionFilter{};
  position_m_ = seen_m;
  pp_ = square(parameters.detection_m);
  vv_ = square(kAnySpeed_mps);
  aa_ = square(parameters.slides_mps2);
}

void BallMotionFilter::jump(const Vec2& seen_m, const BallMotionParameters& parameters) {
  start(seen_m, parameters);
  pp_ = square(parameters.jump_m);
}

void BallMotionFilter::predict(double duration_s, const BallMotionParameters& parameters) {
  const double t = duration_s;
  const double h = t * t / 2;
  position_m_ += t * velocity_mps_ + h * acceleration_mps2_;
  velocity_mps_ += t * acceleration_mps2_;
  pp_ += 2 * (t * pv_ + h * pa_ + t * h * va_) + t * t * vv_ + h * h * aa_;
  pv_ += t * (pa_ + vv_) + 3 * h * va_ + t * h * aa_;
  pa_ += t * va_ + h * aa_;
  vv_ += 2 * t * va_ + t * t * aa_;
  va_ += t * aa_;
  // White-noise jerk, discretised to first order in the step.
  aa_ += (rolls_ ? parameters.rolls_change_m2ps5 : parameters.slides_change_m2ps5) * std::abs(t);
  if (rolls_ && t > 0 && velocity_mps_.dot(acceleration_mps2_) > 0) {
    velocity_mps_ = acceleration_mps2_ = Vec2(0, 0);  // friction has stopped the ball
  }
}

void BallMotionFilter::touch(double duration_s, bool is_soft,
                             const BallMotionParameters& parameters) {
  // A velocity jump at a time uniformly distributed over the interval.
  const double variance = square(is_soft ? parameters.soft_mps : parameters.hard_mps);
  pp_ += variance * square(duration_s) / 3;
  pv_ += variance * duration_s / 2;
  vv_ += variance;
  if (is_soft) {
    begin_to_roll(parameters);
    return;
  }
  rolls_ = false;
  acceleration_mps2_ = Vec2(0, 0);
  pa_ = va_ = 0;
  aa_ = square(parameters.slides_mps2);
}

void BallMotionFilter::begin_to_roll(const BallMotionParameters& parameters) {
  rolls_ = true;
  acceleration_mps2_ = -parameters.rolls_mps2 * direction_of(velocity_mps_, Vec2(0, 0));
  pa_ = va_ = 0;
  aa_ = square(parameters.rolls_off_mps2);
  vv_ += square(parameters.begins_to_roll_mps);
}

double BallMotionFilter::correct(const Vec2& seen_m, const BallMotionParameters& parameters) {
  const Vec2 innovation_m = seen_m - position_m_;
  const double variance = pp_ + square(parameters.detection_m);
  const double position_gain = pp_ / variance;
  const double velocity_gain = pv_ / variance;
  const double acceleration_gain = pa_ / variance;
  position_m_ += position_gain * innovation_m;
  velocity_mps_ += velocity_gain * innovation_m;
  acceleration_mps2_ += acceleration_gain * innovation_m;
  aa_ -= acceleration_gain * pa_;
  va_ -= velocity_gain * pa_;
  vv_ -= velocity_gain * pv_;
  pa_ -= position_gain * pa_;
  pv_ -= position_gain * pv_;
  pp_ -= position_gain * pp_;
  return innovation_m.squaredNorm() / variance + 2 * natural_log(variance / kMillimetre2);
}

Vec2 BallMotionFilter::position_after(double duration_s) const {
  return position_m_ + duration_s * velocity_mps_ + square(duration_s) / 2 * acceleration_mps2_;
}

double BallMotionFilter::position_variance_after(double duration_s) const {
  return std::max(0.0, pp_ + 2 * duration_s * pv_ + square(duration_s) * vv_);
}

}  // namespace autoref::referee
