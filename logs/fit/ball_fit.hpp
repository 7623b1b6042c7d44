// How the ball slides and rolls, estimated from free stretches.
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

// Rolling: deceleration = roll_mps2 + roll_per_s * speed. With few stretches, roll_per_s is taken
// to be 0.
struct RollEstimates {
  Estimate roll_mps2;
  Estimate roll_per_s;
};

// Collects stretches in which the ball rolls or slides.
class BallFit {
 public:
  void add(const RecordedMotion& motion);

  Estimate slide_mps2() const;

  RollEstimates roll() const;

  // The default ball, except for those of the numbers above that could be estimated.
  sim::BallParameters ball() const;

  // Of the first 300 paths with at least 15 detections; nullopt without these, or if there are
  // fewer than four paths. Of `compared`, roll_mps2 and roll_per_s are used.
  std::optional<RollPrediction> roll_prediction(const sim::BallParameters& compared) const;

 private:
  void add_rolling(const FreeStretch& stretch);
  std::optional<Eigen::Vector2d> line_without(std::size_t path) const;

  std::vector<Measured> sliding_mps2_;
  std::vector<Rolling> rolling_;
};

}  // namespace autoref::logs
