// Stretches in which the ball moves freely, with the decelerations that they show.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// A path with constant deceleration: start + speed * t - deceleration * t^2 / 2.
struct OnePhaseFit {
  double start_m = 0;
  double speed_mps = 0;        // at the start
  Measured deceleration_mps2;  // with the standard deviation due to the noise of vision
  double misfit = 0;           // chi-square
};

// A path with one deceleration until `switch_s` and another one from then on.
struct TwoPhaseFit {
  double start_m = 0;
  double speed_mps = 0;
  double switch_s = 0;  // since the first detection
  Measured first_mps2;
  Measured second_mps2;
  double misfit = 0;
};

// A stretch of running play during which the ball, seen by one camera, moves by at least
// kShortestPath_m, away from robots and walls.
struct FreeStretch {
  std::vector<std::size_t> frames;  // those in which the ball is seen
  std::vector<double> times_s;      // since the first detection
  std::vector<double> along_m;      // positions along the line that fits best
  Vec2 centre_m{0, 0};              // a point on that line, at 0
  Vec2 direction{1, 0};             // of the motion
  // Standard deviation of the positions: that of vision's noise or, if the paths in this part of
  // the log are less straight than noise explains, as real cameras' errors make them, more.
  double noise_m = 0;

  // Sum of the squared distances from the line, and whether the noise explains it. A chip does not
  // look straight to a camera that is not above its path, and a deflected ball does not move
  // straight.
  double squares_m2 = 0;
  bool is_straight = false;
  OnePhaseFit one;
  std::optional<TwoPhaseFit> two;  // nullopt if there are too few detections

  // Whether the deceleration is constant, and whether it changes from sliding to rolling. At most
  // one of the two, and neither if no fit is good enough to say so.
  bool has_one_phase() const;
  bool has_two_phases() const;

  // Balls that decelerate harder slide. All carpets and balls known are on the same side: balls
  // roll at 0.2 to 0.6 m/s^2 and slide at 2.5 to 6 m/s^2.
  static constexpr double kSlides_mps2 = 1.3;
  static constexpr double kLeastRolling_mps2 = -0.05;  // below: noise does not explain it
  // With a larger deviation, the deceleration of a sliding ball says too little.
  static constexpr double kVagueSliding_mps2 = 0.6;

  bool slides_then_rolls() const;
  bool rolls_throughout() const;
  bool slides_throughout() const;

  double duration_s() const { return times_s.back(); }
};

std::vector<FreeStretch> free_stretches_in(const RecordedMotion& motion);

// The frames with a detection in each time during which the ball, seen by any camera, is away from
// robots and walls in running play. It may be at rest.
std::vector<std::vector<std::size_t>> free_paths_in(const RecordedMotion& motion);

inline constexpr double kShortestPath_m = 0.15;

// Whether the chi-square of a fit with `freedom` degrees of freedom is at most four standard
// deviations above its mean.
bool is_good_fit(double misfit, double freedom);

// The factors of start, speed, first and second deceleration in the position at `time_s`.
Eigen::RowVector4d path_row(double time_s, double switch_s);

// The minimum of `f` between `low` and `high`, found by golden-section search.
template <typename Function>
double golden_minimum(double low, double high, int steps, const Function& f) {
  constexpr double kSection = 0.381966;
  for (int i = 0; i < steps; ++i) {
    const double left = low + kSection * (high - low);
    const double right = high - kSection * (high - low);
    if (f(left) < f(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return (low + high) / 2;
}

}  // namespace autoref::logs
