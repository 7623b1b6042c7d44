// Intersections of the ball's path with the hulls of robots, and the filter for the ball's motion.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/touch/frame_history.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// The ball's motion while only the carpet acts on it.
//
// A Kalman filter of position, velocity and acceleration with white-noise jerk (Bar-Shalom, Li and
// Kirubarajan 2001, chapter 6; docs/touch-detection.md). The axes are independent and share one
// covariance. It runs forwards or backwards in time.

// Measurement and process noise. Standard deviations are per coordinate.
struct BallMotionParameters {
  // Measurement noise. The detector raises it if vision is noisier, but never lowers it, since a
  // ball may begin to roll between two detections.
  double detection_m = 0.2e-3;
  // Prior deviation of a sliding ball's acceleration: friction decelerates the ball by 3.0 to 3.9
  // m/s2 in a direction that depends on the unknown spin.
  double slides_mps2 = 2.2;
  double slides_change_m2ps5 = 1.0;  // power spectral density of the jerk
  // Prior mean and standard deviation of a rolling ball's deceleration; all carpets in the league
  // are similar.
  double rolls_mps2 = 0.3;
  double rolls_off_mps2 = 0.2;
  double rolls_change_m2ps5 = 0.005;
  double begins_to_roll_mps = 0.02;  // velocity change caused by sliding for part of the frame
  // Standard deviations of the velocity change caused by a touch: one for a kick or bounce, one for
  // a brush after which a rolling ball keeps rolling.
  double hard_mps = 1.5;
  double soft_mps = 0.12;
  double jump_m = 10_mm;  // position error of a ball that takes off or lands
};

class BallMotionFilter {
 public:
  // Starts the filter at a detection, with unknown velocity.
  void start(const Vec2& seen_m, const BallMotionParameters& parameters);

  // Restarts the filter at the estimated position of a ball that takes off or lands.
  void jump(const Vec2& seen_m, const BallMotionParameters& parameters);

  // Predicts the state `duration_s` ahead, or back in time if `duration_s` is negative.
  void predict(double duration_s, const BallMotionParameters& parameters);

  // Adds the process noise of a touch at an unknown time within the last `duration_s`.
  void touch(double duration_s, bool is_soft, const BallMotionParameters& parameters);

  // Switches to the rolling model: the ball has stopped sliding.
  void begin_to_roll(const BallMotionParameters& parameters);

  // Corrects the state with a detection. Returns the deviance of the innovation, minus twice its
  // log-likelihood: the normalised innovation squared plus the log-determinant of its covariance,
  // up to a constant.
  double correct(const Vec2& seen_m, const BallMotionParameters& parameters);

  bool rolls() const { return rolls_; }
  const Vec2& velocity_mps() const { return velocity_mps_; }
  double velocity_variance_m2ps2() const { return vv_; }
  Vec2 position_after(double duration_s) const;
  // Position variance in m2, per coordinate; it neglects the uncertainty of the acceleration.
  double position_variance_after(double duration_s) const;

 private:
  Vec2 position_m_{0, 0};
  Vec2 velocity_mps_{0, 0};
  Vec2 acceleration_mps2_{0, 0};
  bool rolls_ = false;
  // Covariances of position (p), velocity (v) and acceleration (a).
  double pp_ = 0;
  double pv_ = 0;
  double pa_ = 0;
  double vv_ = 0;
  double va_ = 0;
  double aa_ = 0;
};

// Deviances are normalised squared distances: minus twice the log-likelihood of a Gaussian.
struct HullIntersectionParameters {
  double contact_m = 1_mm;  // standard deviation of the gap between bodies that touch
  double slack_m = 1_mm;    // tolerance for the gaps of 0.5 mm and overlaps of 1.5 mm that the
                            // physics engine leaves
  double reach_m = 15_mm;   // reach of the kicker beyond the plate
  double kick_rad = 0.08;   // standard deviation of a kick's direction from the robot's heading
  double robot_m = 0;       // vision noise of robot poses, set by the detector
  double robot_rad = 0;
};

inline constexpr double kNever = 1e9;  // deviance of an impossible event

// The intersection of a path with one robot's hull.
struct HullIntersection {
  RobotId robot;
  double bounce_deviance = kNever;  // deviance of a touch by the hull
  double kick_deviance = kNever;    // deviance of a kick
  double least_gap_m = 1;           // smallest gap from the ball's surface to the hull
  double time_s = 0;                // time of the likeliest touch
  double gap_m = 0;                 // gap at that time
};
using HullIntersections = boost::container::static_vector<HullIntersection, 2 * kMaxRobots>;

struct Walk {
  HullIntersections intersections;
  double through_deviance = 0;  // deviance of passing through hulls, along the whole path
};

// Samples the path from frame `from` to frame `to`, which may be earlier. The deviance of a touch
// is the deviance of the gap between ball and hull at that time, plus the deviance of passing
// through hulls until then. If `to` is earlier than `from`, the path began with a touch, so the
// deviance of a kick also depends on the angle between the robot's heading and the path.
Walk walk(const BallMotionFilter& motion, const FrameHistory& frame_history, std::int64_t from,
          std::int64_t to, const HullIntersectionParameters& parameters);

}  // namespace autoref::referee
