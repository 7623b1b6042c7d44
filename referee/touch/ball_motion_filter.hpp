// The ball's way while nothing but the carpet acts on it.
//
// A Kalman filter of place, velocity and the carpet's acceleration. Both axes are alike and share
// one covariance. It runs forwards in time, or backwards.
#pragma once

#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// How ways are seen, and how they change. Standard deviations are of each coordinate.
struct BallMotionParameters {
  // Of a detection; the detector sets it to the noise it is told of, and to no less than this, for
  // a ball does not begin to roll at a detection.
  double detection_m = 0.2e-3;
  // A ball that slides is slowed by 3.0 to 3.9 m/s2 against its spin's way, whichever that is.
  double slides_mps2 = 2.2;
  double slides_change_m2ps5 = 1.0;  // how the variance of that grows
  // A ball that rolls is slowed by this, about the same on all of the league's carpets.
  double rolls_mps2 = 0.3;
  double rolls_off_mps2 = 0.2;
  double rolls_change_m2ps5 = 0.005;
  double begins_to_roll_mps = 0.02;  // what sliding for a part of a frame changes
  // What a touch changes: a kick or a bounce, and a brush by which a ball that rolls rolls on.
  double hard_mps = 1.5;
  double soft_mps = 0.12;
  double jump_m = 10_mm;  // how well the place of a ball is known that begins or ceases to fly
};

class BallMotionFilter {
 public:
  // Begins at a detection: nothing is known of the velocity.
  void start(const Vec2& seen_m, const BallMotionParameters& parameters);

  // Begins where a ball that flies, or has landed, is taken to be.
  void jump(const Vec2& seen_m, const BallMotionParameters& parameters);

  // Goes on by `duration_s`, which may be negative.
  void predict(double duration_s, const BallMotionParameters& parameters);

  // Somebody touched the ball at some time during the last `duration_s`.
  void touch(double duration_s, bool is_soft, const BallMotionParameters& parameters);

  // The ball has stopped sliding.
  void begin_to_roll(const BallMotionParameters& parameters);

  // Takes in a detection. Returns how badly it fits: minus twice the logarithm of its likelihood,
  // up to a constant.
  double correct(const Vec2& seen_m, const BallMotionParameters& parameters);

  bool rolls() const { return rolls_; }
  const Vec2& velocity_mps() const { return velocity_mps_; }
  double velocity_variance_m2ps2() const { return vv_; }
  Vec2 position_after(double duration_s) const;
  double position_variance_after(double duration_s) const;  // m2, of each coordinate

 private:
  Vec2 position_m_{0, 0};
  Vec2 velocity_mps_{0, 0};
  Vec2 acceleration_mps2_{0, 0};
  bool rolls_ = false;
  // Covariances of place, velocity and acceleration.
  double pp_ = 0;
  double pv_ = 0;
  double pa_ = 0;
  double vv_ = 0;
  double va_ = 0;
  double aa_ = 0;
};

}  // namespace autoref::referee
