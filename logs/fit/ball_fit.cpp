#include "logs/fit/ball_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "logs/third_differences.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kBallSystematic = 0.01;  // share of each estimate
constexpr std::size_t kEnoughStretches = 3;
constexpr std::size_t kEnoughForSlope = 12;  // to see how the deceleration depends on the speed

constexpr double kVagueRolling_mps2 = 0.05;
constexpr double kNearlyAtRest_mps = 0.06;  // slower balls may stop at once
// How much true decelerations vary in a game, in addition to their deviations.
constexpr double kSlidingSpread_mps2 = 0.03;
constexpr double kRollingSpread_mps2 = 0.003;

// Fits deceleration = result[0] + result[1] * speed, without stretches that are far off. The second
// number is 0 unless `has_slope`.
Eigen::Vector2d rolling_line(const std::vector<Rolling>& rolling,
                             std::span<const std::size_t> stretches, bool has_slope) {
  constexpr int kRounds = 5;
  constexpr double kFarthest =
      3.5;  // in deviations, or in those of the residuals if these are larger
  Eigen::Vector2d line(0, 0);
  std::vector<double> off(stretches.size(), 0.0);
  double farthest = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix2d rows = Eigen::Matrix2d::Identity() * 1e-9;
    Eigen::Vector2d values = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      if (off[i] > farthest) continue;
      const Rolling& seen = rolling[stretches[i]];
      const double weight =
          1 / (square(seen.deceleration_mps2.deviation) + square(kRollingSpread_mps2));
      const Eigen::Vector2d row(1, has_slope ? seen.speed_mps : 0);
      rows += weight * row * row.transpose();
      values += weight * row * seen.deceleration_mps2.value;
    }
    line = rows.ldlt().solve(values);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Rolling& seen = rolling[stretches[i]];
      off[i] = std::abs(seen.deceleration_mps2.value - line[0] - line[1] * seen.speed_mps) /
               std::hypot(seen.deceleration_mps2.deviation, kRollingSpread_mps2);
    }
    farthest = kFarthest * std::max(1.0, median(off) / kNormalMedian);
  }
  return line;
}

// The distance between where the ball was seen last and where it is predicted to be, from the first
// third of its detections and a deceleration of line[0] + line[1] * speed.
double prediction_error_m(const Rolling& rolling, const Eigen::Vector2d& line) {
  constexpr int kRounds = 2;  // the first one only finds the speed
  const double start_s = rolling.times_s.front();
  const double length_s = rolling.times_s.back() - start_s;
  Eigen::Vector2d motion(0, 0);
  double deceleration_mps2 = line[0];
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix2d rows = Eigen::Matrix2d::Zero();
    Eigen::Vector2d values = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < rolling.times_s.size() / 3; ++i) {
      const double time_s = rolling.times_s[i] - start_s;
      const Eigen::Vector2d row(1, time_s);
      rows += row * row.transpose();
      values += row * (rolling.along_m[i] + deceleration_mps2 * square(time_s) / 2);
    }
    motion = rows.inverse() * values;
    const double mean_mps = motion[1] - deceleration_mps2 * length_s / 2;
    deceleration_mps2 = line[0] + line[1] * mean_mps;
  }
  return motion[0] + motion[1] * length_s - deceleration_mps2 * square(length_s) / 2 -
         rolling.along_m.back();
}

}  // namespace

void BallFit::add_rolling(const FreeStretch& stretch) {
  Rolling rolling;
  double begins_s = 0;
  double end_mps = 0;
  if (stretch.rolls_throughout()) {
    rolling.deceleration_mps2 = stretch.one.deceleration_mps2;
    const double change_mps = rolling.deceleration_mps2.value * stretch.duration_s();
    rolling.speed_mps = stretch.one.speed_mps - change_mps / 2;
    end_mps = stretch.one.speed_mps - change_mps;
  } else if (stretch.slides_then_rolls()) {
    rolling.deceleration_mps2 = stretch.two->second_mps2;
    const double begin_mps =
        stretch.two->speed_mps - stretch.two->first_mps2.value * stretch.two->switch_s;
    const double change_mps =
        rolling.deceleration_mps2.value * (stretch.duration_s() - stretch.two->switch_s);
    rolling.speed_mps = begin_mps - change_mps / 2;
    begins_s = stretch.two->switch_s;
    end_mps = kNearlyAtRest_mps + 1;  // a ball that was kicked is not about to stop
  } else {
    return;
  }
  const Measured& measured = rolling.deceleration_mps2;
  if (measured.deviation < kVagueRolling_mps2 && measured.value > FreeStretch::kLeastRolling_mps2 &&
      measured.value < FreeStretch::kSlides_mps2 && end_mps > kNearlyAtRest_mps) {
    const auto from = std::lower_bound(stretch.times_s.begin(), stretch.times_s.end(), begins_s);
    rolling.times_s.assign(from, stretch.times_s.end());
    rolling.along_m.assign(stretch.along_m.begin() + (from - stretch.times_s.begin()),
                           stretch.along_m.end());
    rolling_.push_back(std::move(rolling));
  }
}

void BallFit::add(const RecordedMotion& motion) {
  for (const FreeStretch& stretch : free_stretches_in(motion)) {
    if (stretch.slides_then_rolls() &&
        stretch.two->first_mps2.deviation < FreeStretch::kVagueSliding_mps2)
      sliding_mps2_.push_back(stretch.two->first_mps2);
    if (stretch.slides_throughout()) sliding_mps2_.push_back(stretch.one.deceleration_mps2);
    add_rolling(stretch);
  }
}

Estimate BallFit::slide_mps2() const {
  return {static_cast<std::int64_t>(sliding_mps2_.size()),
          bootstrap_estimate(sliding_mps2_.size(), kEnoughStretches, kBallSystematic,
                             [&](std::span<const std::size_t> stretches) -> std::optional<double> {
                               return robust_mean(elements_at(sliding_mps2_, stretches),
                                                  kSlidingSpread_mps2);
                             })};
}

RollEstimates BallFit::roll() const {
  const auto seen = static_cast<std::int64_t>(rolling_.size());
  const bool has_slope = rolling_.size() >= kEnoughForSlope;
  const auto estimates = bootstrap_estimates(
      rolling_.size(), kEnoughStretches, {kBallSystematic, kBallSystematic},
      [&](std::span<const std::size_t> stretches) -> std::optional<std::vector<double>> {
        const Eigen::Vector2d line = rolling_line(rolling_, stretches, has_slope);
        return std::vector{line[0], line[1]};
      });
  RollEstimates roll{{seen, std::nullopt}, {seen, std::nullopt}};
  if (estimates) roll.roll_mps2.number = estimates->front();
  if (estimates && has_slope) roll.roll_per_s.number = estimates->back();
  return roll;
}

std::optional<Eigen::Vector2d> BallFit::line_without(std::size_t path) const {
  std::vector<std::size_t> others;
  others.reserve(rolling_.size());
  for (std::size_t i = 0; i < rolling_.size(); ++i) {
    if (i != path) others.push_back(i);
  }
  if (others.size() < kEnoughStretches) return std::nullopt;
  return rolling_line(rolling_, others, others.size() >= kEnoughForSlope);
}

sim::BallParameters BallFit::ball() const {
  sim::BallParameters ball;
  const RollEstimates estimates = roll();
  if (estimates.roll_mps2.number) ball.roll_mps2 = estimates.roll_mps2.number->value;
  if (estimates.roll_per_s.number) ball.roll_per_s = estimates.roll_per_s.number->value;
  if (const Estimate slide = slide_mps2(); slide.number) ball.slide_mps2 = slide.number->value;
  return ball;
}

std::optional<RollPrediction> BallFit::roll_prediction(const sim::BallParameters& compared) const {
  constexpr std::int64_t kMostPaths = 300;  // each needs a fit of its own
  constexpr std::size_t kFewestDetections = 15;
  RollPrediction sums;
  for (std::size_t i = 0; i < rolling_.size() && sums.paths < kMostPaths; ++i) {
    const Rolling& path = rolling_[i];
    const auto line = line_without(i);
    if (!line || path.times_s.size() < kFewestDetections) continue;
    ++sums.paths;
    sums.fitted_m += square(prediction_error_m(path, *line));
    sums.compared_m += square(prediction_error_m(path, {compared.roll_mps2, compared.roll_per_s}));
    sums.travelled_m += path.along_m.back() - path.along_m[path.along_m.size() / 3];
  }
  if (sums.paths == 0) return std::nullopt;
  const auto paths = static_cast<double>(sums.paths);
  return RollPrediction{sums.paths, std::sqrt(sums.fitted_m / paths),
                        std::sqrt(sums.compared_m / paths), sums.travelled_m / paths};
}

}  // namespace autoref::logs
