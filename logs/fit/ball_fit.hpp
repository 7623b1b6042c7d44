// How the ball slides and rolls, and how it was kicked, estimated from free stretches.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "logs/fit/free_stretches.hpp"
#include "logs/fit/recorded_motion.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::logs {

// A ball that rolls: its deceleration at its mean speed, and its path.
struct Rolling {
  Measured deceleration_mps2;
  double speed_mps = 0;
  std::vector<double> times_s;  // of the detections
  std::vector<double> along_m;  // along a straight line
};

// How well the end of a rolling ball's path is predicted from the first third of its detections:
// root mean square of the distance between prediction and detection.
struct RollPrediction {
  std::int64_t paths = 0;
  double fitted_m = 0;     // with what the other paths of the log show
  double compared_m = 0;   // with the ball compared with
  double travelled_m = 0;  // mean distance that is predicted
};

// Distance from a robot's centre to that of a ball at its plate.
inline constexpr double kPlateTouch_m = kFrontDistance_m + kBallRadius_m;

// Collects stretches in which the ball rolls or slides.
class BallFit {
 public:
  void add(const RecordedMotion& motion);

  Estimate slide_mps2() const;

  // Rolling: deceleration = roll_mps2 + roll_per_s * speed. With few stretches, roll_per_s is taken
  // to be 0.
  Estimate roll_mps2() const;
  Estimate roll_per_s() const;

  // Of the first 300 paths with at least 15 detections; nullopt without these, or if there are
  // fewer than four paths. Of `compared`, roll_mps2 and roll_per_s are used.
  std::optional<RollPrediction> roll_prediction(const sim::BallParameters& compared) const;

 private:
  void add_rolling(const FreeStretch& stretch);
  std::optional<Eigen::Vector2d> line_without(std::size_t path) const;
  std::optional<Estimated> roll(Eigen::Index parameter) const;

  std::vector<Measured> sliding_mps2_;
  std::vector<Rolling> rolling_;
};

// A straight kick, found by following a sliding ball back to the front of the robot nearest to
// where the stretch begins.
struct Kick {
  std::size_t robot = 0;  // its index in RecordedMotion::robots
  double time_s = 0;      // when the ball left the plate
  double speed_mps = 0;   // of the ball then
  Vec2 direction{1, 0};   // of the ball, a unit vector
  double across_m = 0;    // of the ball then: to the left of the middle of the plate
  double angle_rad = 0;   // from the robot's heading to the ball's direction
  // Speed at which the ball begins to roll, as a fraction of its speed at the kick. Its deviation
  // is infinite if the ball slides throughout the stretch.
  Measured switch_ratio;

  // Whether it looks like a kick, and not like a deflection or a ball that a robot drives away
  // from.
  bool is_clear() const;
};

// The kicks in the motion. Of `ball`, slide_mps2, roll_mps2 and roll_per_s are used.
std::vector<Kick> kicks_in(const RecordedMotion& motion, const sim::BallParameters& ball);

// The switch ratio most of `kicks` agree on. A deflected ball has spin, so it begins to roll at
// another ratio.
Estimate switch_ratio_of(const std::vector<Kick>& kicks);

}  // namespace autoref::logs
