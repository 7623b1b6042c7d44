#include "logs/fit/chip_fit.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <optional>

#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// The last frames in which a robot may touch a ball that soon is away from all robots.
std::vector<std::size_t> chip_kick_frames(const RecordedMotion& motion) {
  constexpr double kTouching_m = 125_mm;  // from the nearest robot's centre to the ball's
  constexpr double kAway_m = 150_mm;
  constexpr double kLongestLeaving_s = 0.4;
  std::vector<std::size_t> frames;
  bool is_touched = false;
  std::size_t touch = 0;
  for (std::size_t i = 0; i < motion.frames(); ++i) {
    if (motion.ball[i].is_seen && motion.nearest_m[i] < kTouching_m) {
      is_touched = true;
      touch = i;
    }
    if (!is_touched || motion.nearest_m[i] < kAway_m) continue;
    if (motion.times_s[i] - motion.times_s[touch] < kLongestLeaving_s) frames.push_back(touch);
    is_touched = false;
  }
  return frames;
}

// The ball's detections by calibrated cameras after `frame`.
KickedBall kicked_ball(const RecordedMotion& motion, std::size_t frame) {
  constexpr double kLongestPath_s = 1.6;
  const BallSight& rest = motion.ball[frame];
  KickedBall ball{rest.position_m, {}, motion.interval_s, motion.ball_noise_m};
  for (std::size_t i = frame + 1; i < motion.frames(); ++i) {
    const BallSight& sight = motion.ball[i];
    const double since_s = sight.time_s - rest.time_s;
    if (since_s > kLongestPath_s) break;
    const auto camera = motion.cameras.find(sight.camera);
    if (sight.is_seen && camera != motion.cameras.end() && since_s > 0)
      ball.sights.push_back({since_s, sight.position_m, camera->second});
  }
  return ball;
}

// The mean of what single chips show.
Estimate kept_speed(const std::vector<Measured>& chips) {
  constexpr double kLeastDeviation = 0.006;
  constexpr double kChipError = 0.15;
  constexpr double kDeviations = 2.5;  // Student's distribution for about five chips
  Estimate estimate;
  estimate.episodes = static_cast<std::int64_t>(chips.size());
  if (chips.empty()) return estimate;
  const double mean = robust_mean(chips, kLeastDeviation);
  double weights = 0;
  double squares = 0;
  for (const Measured& chip : chips) {
    const double weight = 1 / (square(chip.deviation) + square(kLeastDeviation));
    weights += weight;
    squares += weight * square(chip.value - mean);
  }
  const auto n = static_cast<double>(chips.size());
  const double scatter = std::sqrt(std::max(1.0, squares / std::max(1.0, n - 1)) / weights);
  const double half = std::hypot(kDeviations * scatter, kChipError * mean / n);
  estimate.number = {mean, mean - half, mean + half};
  return estimate;
}

constexpr double kIntervalTail = 0.025;  // of a 95 % interval, on either side

struct ChipAngles {
  double mean_deg = 0;
  double variance_deg2 = 0;   // between the chips
  double measuring_deg2 = 0;  // mean variance due to errors of measurement
};

ChipAngles angles_of(const std::vector<Chip>& chips) {
  constexpr double kLeastDeviation_deg = 0.3;  // what simulated chips of equal angle show
  const auto n = static_cast<double>(chips.size());
  ChipAngles angles;
  for (const Chip& chip : chips) {
    angles.mean_deg += chip.angle_deg.value / n;
    angles.measuring_deg2 += square(std::max(chip.angle_deg.deviation, kLeastDeviation_deg)) / n;
  }
  for (const Chip& chip : chips)
    angles.variance_deg2 += square(chip.angle_deg.value - angles.mean_deg) / (n - 1);
  return angles;
}

// Without the eighth of the chips whose angles are farthest from the median: as many may be balls
// that were deflected into the air.
std::vector<Chip> likely_chips(std::vector<Chip> chips) {
  constexpr std::size_t kShareOfOthers = 8;
  std::vector<double> angles_deg;
  angles_deg.reserve(chips.size());
  for (const Chip& chip : chips) angles_deg.push_back(chip.angle_deg.value);
  const double middle_deg = median(std::move(angles_deg));
  std::sort(chips.begin(), chips.end(), [&](const Chip& a, const Chip& b) {
    return std::abs(a.angle_deg.value - middle_deg) < std::abs(b.angle_deg.value - middle_deg);
  });
  chips.resize(chips.size() - chips.size() / kShareOfOthers);
  return chips;
}

}  // namespace

void ChipFit::add(const RecordedMotion& motion) {
  double landing_s = motion.times_s.front();
  for (const std::size_t frame : chip_kick_frames(motion)) {
    // A flying ball may seem to touch robots below it.
    if (motion.ball[frame].time_s < landing_s) continue;
    const auto path = chip_path_of(kicked_ball(motion, frame));
    if (!path) continue;
    landing_s = motion.ball[frame].time_s + path->landing_s;
    if (path->chip) chips_.push_back(*path->chip);
  }
}

Estimate ChipFit::hop_first_xy() const {
  std::vector<Measured> kept;
  kept.reserve(chips_.size());
  for (const Chip& chip : chips_) kept.push_back(chip.first_xy);
  return kept_speed(kept);
}

Estimate ChipFit::hop_first_z() const {
  std::vector<Measured> kept;
  kept.reserve(chips_.size());
  for (const Chip& chip : chips_) {
    if (chip.first_z) kept.push_back(*chip.first_z);
  }
  return kept_speed(kept);
}

Estimate ChipFit::hop_later_xy() const {
  std::vector<Measured> kept;
  kept.reserve(chips_.size());
  for (const Chip& chip : chips_) {
    if (chip.later_xy) kept.push_back(*chip.later_xy);
  }
  return kept_speed(kept);
}

Estimate ChipFit::chip_angle_deg() const {
  constexpr std::size_t kEnough = 3;
  constexpr double kCalibration_deg = 0.5;  // error of the cameras' heights
  Estimate estimate{static_cast<std::int64_t>(chips_.size()), std::nullopt};
  if (chips_.size() < kEnough) return estimate;
  const auto n = static_cast<double>(chips_.size());
  const ChipAngles angles = angles_of(chips_);
  const double deviations =
      boost::math::quantile(boost::math::students_t(n - 1), 1 - kIntervalTail);
  const double half =
      std::hypot(deviations * std::sqrt(angles.variance_deg2 / n), kCalibration_deg);
  estimate.number = {angles.mean_deg, angles.mean_deg - half, angles.mean_deg + half};
  return estimate;
}

Estimate ChipFit::chip_angle_noise_deg() const {
  constexpr std::size_t kEnough = 8;
  Estimate estimate{static_cast<std::int64_t>(chips_.size()), std::nullopt};
  if (chips_.size() < kEnough) return estimate;
  const ChipAngles angles = angles_of(chips_);
  const auto freedom = static_cast<double>(chips_.size() - 1);
  const boost::math::chi_squared distribution(freedom);
  const auto variance_at = [&](double share) {
    return angles.variance_deg2 * freedom / boost::math::quantile(distribution, share);
  };
  // The upper bound does not rely on the errors of measurement, and the lower one not on every
  // chip.
  const auto noise_deg = [&](double variance_deg2) {
    return std::sqrt(std::max(0.0, variance_deg2 - angles.measuring_deg2));
  };
  const double likely =
      angles_of(likely_chips(chips_)).variance_deg2 / std::max(angles.variance_deg2, 1e-9);
  estimate.number = {noise_deg(angles.variance_deg2),
                     noise_deg(std::min(likely, 1.0) * variance_at(1 - kIntervalTail)),
                     std::sqrt(variance_at(kIntervalTail))};
  return estimate;
}

}  // namespace autoref::logs
