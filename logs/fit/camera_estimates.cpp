// The estimates of CameraFit from what it collected (camera_fit.cpp).
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "logs/fit/camera_fit.hpp"
#include "logs/third_differences.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

using Groups = std::span<const std::size_t>;

// Errors of the estimates in simulated games with known parameters beyond what the bootstrap
// explains, as a share of the value.
constexpr double kClockError = 1e-4;  // of a computer; a steady frame rate shows no error itself
constexpr double kBallNoiseError = 0.02;
constexpr double kRobotNoiseError = 0.015;
constexpr double kBallMissesError = 0.04;
constexpr double kNearMissesError = 0.04;
constexpr double kNearLengthError = 0.06;
constexpr double kRobotMissesError = 0.02;
constexpr double kRobotGapsError = 0.04;
constexpr double kFalseBallsError = 0.04;

// What an estimate needs at least.
constexpr std::size_t kFewestBlocks = 3;
constexpr std::size_t kFewestDifferences = 200;
constexpr std::size_t kFewestStillRobots = 30;
constexpr std::size_t kFewestRests = 5;
constexpr double kFewestFar = 500;  // frames with the ball far from robots
constexpr double kFewestNear = 300;
constexpr double kFewestRobotFrames = 1000;
constexpr double kFewestLongRuns = 10;
constexpr double kFewestFalseBalls = 3;

constexpr double kMostNoise = 6;  // medians; robots with more did not stand still after all

// Quantiles of rests.
constexpr double kUsualRests = 0.5;
// Robots that hold their position keep moving a little. In simulated games without drift, even the
// calmest move by this much.
constexpr double kCalmestRests = 0.1;
constexpr double kOwnMotion_m = 0.25_mm;

constexpr std::size_t kNearBins = 10;
constexpr double kClearNearMisses = 0.01;  // near_robots_m means nothing if they may be fewer

template <typename Block, typename Value>
std::vector<Value> pooled(const std::vector<Block>& blocks, Groups groups,
                          std::vector<Value> Block::*values) {
  std::vector<Value> result;
  for (const std::size_t i : groups)
    result.insert(result.end(), (blocks[i].*values).begin(), (blocks[i].*values).end());
  return result;
}

std::vector<std::size_t> every_group(std::size_t groups) {
  std::vector<std::size_t> all(groups);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void add_to(GapBin& sum, const GapBin& bin) {
  sum.frames += bin.frames;
  sum.missed += bin.missed;
  sum.sum_m += bin.sum_m;
}

GapBin total_of(std::span<const GapBin> bins) {
  GapBin sum;
  for (const GapBin& bin : bins) add_to(sum, bin);
  return sum;
}

// The deviation at the given quantile of rests, if it exceeds what the objects' own motion may be.
Estimate drift_of(const std::vector<double>& drifts_m2, double rests, double own_motion_m) {
  const auto estimator = [&](Groups groups) -> std::optional<double> {
    std::vector<double> chosen(groups.size());
    std::transform(groups.begin(), groups.end(), chosen.begin(),
                   [&](std::size_t i) { return drifts_m2[i]; });
    return std::sqrt(std::max(0.0, quantile(std::move(chosen), rests)));
  };
  Estimate result{std::ssize(drifts_m2),
                  bootstrap_estimate(drifts_m2.size(), kFewestRests, 0, estimator)};
  if (result.number && result.number->low <= own_motion_m)
    result.number = Estimated{0, 0, result.number->high};
  return result;
}

}  // namespace

Estimate CameraFit::frame_rate_hz() const {
  std::int64_t intervals = 0;
  for (const Block& block : blocks_) intervals += std::ssize(block.intervals_s);
  const auto estimator = [&](Groups groups) -> std::optional<double> {
    auto intervals_s = pooled(blocks_, groups, &Block::intervals_s);
    if (intervals_s.empty()) return std::nullopt;
    return 1 / median(std::move(intervals_s));
  };
  return {intervals, bootstrap_estimate(blocks_.size(), 1, kClockError, estimator)};
}

Estimate CameraFit::ball_noise_m() const {
  std::int64_t differences = 0;
  for (const Block& block : blocks_) differences += std::ssize(block.ball_differences_m);
  const auto estimator = [&](Groups groups) -> std::optional<double> {
    auto differences_m = pooled(blocks_, groups, &Block::ball_differences_m);
    if (differences_m.size() < kFewestDifferences) return std::nullopt;
    return noise_in(std::move(differences_m));
  };
  return {differences,
          bootstrap_estimate(blocks_.size(), kFewestBlocks, kBallNoiseError, estimator)};
}

Estimate CameraFit::robot_noise(double StillRobot::*noise2) const {
  std::int64_t windows = 0;
  for (const Block& block : blocks_) windows += std::ssize(block.still_robots);
  const auto estimator = [&](Groups groups) -> std::optional<double> {
    const std::vector<StillRobot> robots = pooled(blocks_, groups, &Block::still_robots);
    if (robots.size() < kFewestStillRobots) return std::nullopt;
    std::vector<double> squares(robots.size());
    std::transform(robots.begin(), robots.end(), squares.begin(),
                   [&](const StillRobot& robot) { return robot.*noise2; });
    const double most = kMostNoise * median(squares);
    std::erase_if(squares, [&](double value) { return value > most; });
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) /
                     static_cast<double>(squares.size()));
  };
  return {windows, bootstrap_estimate(blocks_.size(), kFewestBlocks, kRobotNoiseError, estimator)};
}

Estimate CameraFit::robot_noise_m() const { return robot_noise(&StillRobot::noise_m2); }
Estimate CameraFit::robot_noise_rad() const { return robot_noise(&StillRobot::noise_rad2); }
Estimate CameraFit::ball_drift_m() const { return drift_of(ball_drifts_m2_, kUsualRests, 0); }
Estimate CameraFit::robot_drift_m() const {
  return drift_of(robot_drifts_m2_, kCalmestRests, kOwnMotion_m);
}

CameraFit::GapBins CameraFit::gaps_of(Groups groups) const {
  GapBins sum;
  for (const std::size_t i : groups) {
    for (std::size_t k = 0; k < sum.size(); ++k) add_to(sum[k], blocks_[i].gaps[k]);
  }
  return sum;
}

CameraFit::MissEstimates CameraFit::miss_estimates() const {
  const GapBins all = gaps_of(every_group(blocks_.size()));
  const Estimate none{static_cast<std::int64_t>(total_of(all).missed), std::nullopt};
  if (total_of(std::span(all).first(kNearBins)).frames < kFewestNear)
    return {far_misses(), none, none};
  const auto estimator = [&](Groups groups) -> std::optional<std::vector<double>> {
    const GapBins bins = gaps_of(groups);
    if (total_of(std::span(bins).subspan(kFarBin)).frames < kFewestFar) return std::nullopt;
    const MissCurve curve = fitted_miss_curve(bins);
    return std::vector{curve.far, curve.near, curve.near_m};
  };
  const auto numbers =
      bootstrap_estimates(blocks_.size(), kFewestBlocks,
                          {kBallMissesError, kNearMissesError, kNearLengthError}, estimator);
  if (!numbers) return {none, none, none};
  const auto with = [&](const Estimated& number) { return Estimate{none.episodes, number}; };
  const bool is_clear = (*numbers)[1].low > kClearNearMisses;
  return {with((*numbers)[0]), with((*numbers)[1]), is_clear ? with((*numbers)[2]) : none};
}

Estimate CameraFit::far_misses() const {
  const auto estimator = [&](Groups groups) -> std::optional<double> {
    const GapBins bins = gaps_of(groups);
    const GapBin far = total_of(std::span(bins).subspan(kFarBin));
    if (far.frames < kFewestFar) return std::nullopt;
    return far.missed / far.frames;
  };
  const GapBins all = gaps_of(every_group(blocks_.size()));
  return {static_cast<std::int64_t>(total_of(std::span(all).subspan(kFarBin)).missed),
          bootstrap_estimate(blocks_.size(), kFewestBlocks, kBallMissesError, estimator)};
}

Estimate CameraFit::ball_misses() const { return miss_estimates().far; }
Estimate CameraFit::ball_misses_near_robots() const { return miss_estimates().near; }
Estimate CameraFit::near_robots_m() const { return miss_estimates().near_m; }

CameraFit::RobotCounts CameraFit::robot_counts(Groups groups) const {
  RobotCounts sum;
  for (const std::size_t i : groups) {
    const RobotCounts& robots = blocks_[i].robots;
    sum.frames += robots.frames;
    sum.missed += robots.missed;
    sum.long_runs += robots.long_runs;
    sum.missed_in_long_runs += robots.missed_in_long_runs;
  }
  return sum;
}

// The lengths of gaps are evenly distributed from 1 to a longest one, so the mean of those that are
// at least kLongRun is halfway between these two, which also gives the number of shorter gaps.
CameraFit::RobotMissEstimates CameraFit::robot_miss_estimates() const {
  const RobotCounts all = robot_counts(every_group(blocks_.size()));
  const Estimate none{static_cast<std::int64_t>(all.missed), std::nullopt};
  const bool has_gaps = all.long_runs >= kFewestLongRuns;
  const std::vector<double> intervals_s =
      pooled(blocks_, every_group(blocks_.size()), &Block::intervals_s);
  const double interval_s = intervals_s.empty() ? 0 : median(intervals_s);
  const auto estimator = [&](Groups groups) -> std::optional<std::vector<double>> {
    const RobotCounts counts = robot_counts(groups);
    if (counts.frames < kFewestRobotFrames) return std::nullopt;
    if (!has_gaps) return std::vector{counts.missed / counts.frames, 0.0, 0.0};
    if (counts.long_runs == 0) return std::nullopt;
    const double longest =
        std::max(2 * counts.missed_in_long_runs / counts.long_runs - kLongRun, kLongRun + 1.0);
    const double gaps = counts.long_runs * longest / (longest - kLongRun + 1);
    const double mean = (longest + 1) / 2;
    const double in_gaps = std::min(gaps * mean, counts.missed);
    return std::vector{(counts.missed - in_gaps) / (counts.frames - in_gaps),
                       in_gaps / counts.frames, mean * interval_s};
  };
  const auto numbers =
      bootstrap_estimates(blocks_.size(), kFewestBlocks,
                          {kRobotMissesError, kRobotGapsError, kRobotGapsError}, estimator);
  if (!numbers) return {none, none, none};
  const auto with = [&](const Estimated& number) { return Estimate{none.episodes, number}; };
  if (!has_gaps) return {with((*numbers)[0]), none, none};
  return {with((*numbers)[0]), with((*numbers)[1]), with((*numbers)[2])};
}

Estimate CameraFit::robot_misses() const { return robot_miss_estimates().misses; }
Estimate CameraFit::robot_gaps() const { return robot_miss_estimates().gaps; }
Estimate CameraFit::robot_gap_s() const { return robot_miss_estimates().gap_s; }

Estimate CameraFit::false_balls_per_s() const {
  double count = 0;
  for (const Block& block : blocks_) count += block.false_balls.count;
  Estimate result{static_cast<std::int64_t>(count), std::nullopt};
  if (count < kFewestFalseBalls) return result;
  result.number = bootstrap_estimate(blocks_.size(), kFewestBlocks, kFalseBallsError,
                                     [&](Groups groups) -> std::optional<double> {
                                       FalseBalls sum;
                                       for (const std::size_t i : groups) {
                                         sum.count += blocks_[i].false_balls.count;
                                         sum.robots_s += blocks_[i].false_balls.robots_s;
                                       }
                                       if (sum.robots_s == 0) return std::nullopt;
                                       return sum.count / sum.robots_s;
                                     });
  return result;
}

}  // namespace autoref::logs
