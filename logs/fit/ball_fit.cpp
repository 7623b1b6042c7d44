#include "logs/fit/ball_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "logs/third_differences.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kBallSystematic = 0.01;  // share of each estimate
constexpr std::size_t kEnoughStretches = 3;
constexpr std::size_t kEnoughForSlope = 12;  // to see how the deceleration depends on the speed
constexpr std::size_t kEnoughKicks = 5;

// A ball that decelerates harder than this slides; all carpets and balls known are on the same
// side: balls roll at 0.2 to 0.6 m/s^2 and slide at 2.5 to 6 m/s^2.
constexpr double kSlides_mps2 = 1.3;
constexpr double kLeastContrast = 2;        // of the decelerations of two phases
constexpr double kVagueSliding_mps2 = 0.6;  // deviation from which a deceleration says too little
constexpr double kVagueRolling_mps2 = 0.05;
constexpr double kLeastRolling_mps2 = -0.05;  // below: noise does not explain it
constexpr double kNearlyAtRest_mps = 0.06;    // slower balls may stop at once
// How much true decelerations vary in a game, in addition to their deviations.
constexpr double kSlidingSpread_mps2 = 0.03;
constexpr double kRollingSpread_mps2 = 0.003;

bool slides_then_rolls(const FreeStretch& stretch) {
  return stretch.has_two_phases() && stretch.two->first_mps2.value > kSlides_mps2 &&
         stretch.two->first_mps2.value > kLeastContrast * stretch.two->second_mps2.value;
}

// A rolling ball whose deceleration falls with its speed does not quite have one phase.
bool rolls_throughout(const FreeStretch& stretch) {
  if (stretch.has_one_phase()) return true;
  if (!stretch.has_two_phases()) return false;
  const auto is_rolling = [](const Measured& deceleration) {
    return deceleration.value > kLeastRolling_mps2 && deceleration.value < kSlides_mps2;
  };
  return is_rolling(stretch.two->first_mps2) && is_rolling(stretch.two->second_mps2);
}

bool slides_throughout(const FreeStretch& stretch) {
  return stretch.has_one_phase() && stretch.one.deceleration_mps2.value > kSlides_mps2 &&
         stretch.one.deceleration_mps2.deviation < kVagueSliding_mps2;
}

// Where the robot's plate touches the ball, and how far from it the ball has certainly left.
constexpr double kLeavesPlate_m = 3_mm;
constexpr double kLongestRunBack_s = 0.35;
constexpr int kStepsPerFrame = 4;
constexpr double kRunBackError_s = 4e-3;

// The start and speed of a stretch whose decelerations are given.
struct KnownFit {
  double start_m = 0;
  double speed_mps = 0;
  double switch_s = 0;
  double misfit = 0;
};

// The decelerations of the two phases. A rolling ball's depends on its speed, of which the mean is
// used.
Eigen::Vector2d decelerations_of(const FreeStretch& stretch, const sim::BallParameters& ball) {
  double speed_mps = 0;
  if (slides_then_rolls(stretch)) {
    const TwoPhaseFit& fit = *stretch.two;
    speed_mps = fit.speed_mps - fit.first_mps2.value * fit.switch_s -
                fit.second_mps2.value * (stretch.duration_s() - fit.switch_s) / 2;
  }
  return {ball.slide_mps2, ball.roll_mps2 + ball.roll_per_s * std::max(speed_mps, 0.0)};
}

KnownFit known_fit(const FreeStretch& stretch, const Eigen::Vector2d& decelerations,
                   double switch_s) {
  Eigen::Matrix2d rows = Eigen::Matrix2d::Zero();
  Eigen::Vector2d values = Eigen::Vector2d::Zero();
  double squares = 0;
  for (std::size_t i = 0; i < stretch.times_s.size(); ++i) {
    const Eigen::RowVector4d row = path_row(stretch.times_s[i], switch_s);
    const double value = stretch.along_m[i] - row.tail<2>() * decelerations;
    rows += row.head<2>().transpose() * row.head<2>();
    values += row.head<2>().transpose() * value;
    squares += value * value;
  }
  const Eigen::Vector2d unknowns = rows.inverse() * values;
  return {unknowns[0], unknowns[1], switch_s,
          std::max(squares - unknowns.dot(values), 0.0) / square(stretch.noise_m)};
}

KnownFit best_known_fit(const FreeStretch& stretch, const Eigen::Vector2d& decelerations) {
  constexpr double kSearch_s =
      0.1;  // to both sides of the switch found without known decelerations
  constexpr double kEarliest_s = 0.01;
  constexpr int kSteps = 25;
  if (!slides_then_rolls(stretch))
    return known_fit(stretch, decelerations, stretch.duration_s() + 1);
  const double switch_s =
      golden_minimum(std::max(stretch.two->switch_s - kSearch_s, kEarliest_s),
                     std::min(stretch.two->switch_s + kSearch_s, stretch.duration_s()), kSteps,
                     [&](double at_s) { return known_fit(stretch, decelerations, at_s).misfit; });
  return known_fit(stretch, decelerations, switch_s);
}

// The covariance of speed and time of the switch.
Eigen::Matrix2d covariance_of(const FreeStretch& stretch, const Eigen::Vector2d& decelerations,
                              double switch_s) {
  constexpr double kStep_s = 1e-3;
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
  for (const double time_s : stretch.times_s) {
    const double slope = (path_row(time_s, switch_s + kStep_s).tail<2>() -
                          path_row(time_s, switch_s - kStep_s).tail<2>()) *
                         decelerations;
    const Eigen::Vector3d row(1, time_s, slope / (2 * kStep_s));
    rows += row * row.transpose();
  }
  const Eigen::Matrix3d inverse = rows.inverse() * square(stretch.noise_m);
  return inverse.bottomRightCorner<2, 2>();
}

// When the ball, followed back from the first detection, leaves the robot's plate, and where it is
// then in the robot's frame.
struct Leaving {
  double before_s = 0;  // before the first detection
  RobotSight robot;
  Vec2 ball_m{0, 0};  // in the robot's frame
};

std::optional<Leaving> leaving_of(const RecordedMotion& motion, const FreeStretch& stretch,
                                  const KnownFit& fit, double slide_mps2, std::size_t robot) {
  const double start_s = motion.ball[stretch.frames.front()].time_s;
  const double step_s = motion.interval_s / kStepsPerFrame;
  const double gone_m = kPlateTouch_m + kLeavesPlate_m;
  std::optional<Leaving> later;
  const int steps = static_cast<int>(kLongestRunBack_s / step_s);
  for (int step = 0; step <= steps; ++step) {
    const double before_s = step * step_s;
    const RobotSight sight = motion.robot_at(robot, start_s - before_s);
    if (!sight.is_known || start_s - before_s < motion.times_s.front()) return std::nullopt;
    const double along_m =
        fit.start_m - fit.speed_mps * before_s - slide_mps2 * before_s * before_s / 2;
    const Vec2 ball_m = to_local(stretch.centre_m + along_m * stretch.direction - sight.position_m,
                                 heading_of(sight.heading_rad));
    if (ball_m.x() <= gone_m) {
      const double share =
          later ? std::clamp((later->ball_m.x() - gone_m) / (later->ball_m.x() - ball_m.x()), 0.0,
                             1.0)
                : 0;
      const double from_s = later ? later->before_s : before_s;
      return Leaving{from_s + share * (before_s - from_s), sight, ball_m};
    }
    later = Leaving{before_s, sight, ball_m};
  }
  return std::nullopt;
}

std::optional<Kick> kick_before(const RecordedMotion& motion, const FreeStretch& stretch,
                                const sim::BallParameters& ball) {
  const bool has_switch = slides_then_rolls(stretch);
  const Eigen::Vector2d decelerations = decelerations_of(stretch, ball);
  const KnownFit fit = best_known_fit(stretch, decelerations);
  if (!is_good_fit(fit.misfit, static_cast<double>(stretch.frames.size()) - 3)) return std::nullopt;
  const std::size_t first = stretch.frames.front();
  const std::size_t robot = motion.nearest_robot[first > 0 ? first - 1 : 0];
  if (robot >= motion.robots.size()) return std::nullopt;
  const auto leaving = leaving_of(motion, stretch, fit, ball.slide_mps2, robot);
  if (!leaving) return std::nullopt;

  Kick kick;
  kick.robot = robot;
  kick.time_s = motion.ball[first].time_s - leaving->before_s;
  kick.speed_mps = fit.speed_mps + ball.slide_mps2 * leaving->before_s;
  kick.direction = stretch.direction;
  kick.across_m = leaving->ball_m.y();
  kick.angle_rad = angle_between(heading_of(leaving->robot.heading_rad), stretch.direction);
  kick.switch_ratio.deviation = std::numeric_limits<double>::infinity();
  if (has_switch) {
    const double rolls_mps = fit.speed_mps - ball.slide_mps2 * fit.switch_s;
    const double ratio = rolls_mps / kick.speed_mps;
    const Eigen::Vector2d slope((1 - ratio) / kick.speed_mps, -ball.slide_mps2 / kick.speed_mps);
    const double variance = slope.dot(covariance_of(stretch, decelerations, fit.switch_s) * slope);
    kick.switch_ratio = {ratio,
                         std::hypot(std::sqrt(std::max(variance, 0.0)),
                                    ratio / kick.speed_mps * ball.slide_mps2 * kRunBackError_s)};
  }
  return kick;
}

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

// The value at which most of `ratios` are, and the mean of those near it.
double common_ratio(const std::vector<Measured>& ratios) {
  constexpr double kLowest = 0.45;
  constexpr double kHighest = 0.9;
  constexpr int kGrid = 226;
  constexpr double kSpread = 0.008;  // from one kick to the next
  constexpr double kFarthest = 2.5;  // in deviations
  constexpr int kRounds = 5;
  const auto width_of = [](const Measured& ratio) { return std::hypot(ratio.deviation, kSpread); };
  double best = kLowest;
  double densest = 0;
  for (int i = 0; i < kGrid; ++i) {
    const double at = kLowest + (kHighest - kLowest) * i / (kGrid - 1);
    double density = 0;
    for (const Measured& ratio : ratios)
      density += std::exp(-square((at - ratio.value) / width_of(ratio)) / 2) / width_of(ratio);
    if (density > densest) {
      densest = density;
      best = at;
    }
  }
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    double weight = 0;
    for (const Measured& ratio : ratios) {
      if (std::abs(ratio.value - best) > kFarthest * width_of(ratio)) continue;
      sum += ratio.value / square(width_of(ratio));
      weight += 1 / square(width_of(ratio));
    }
    if (weight > 0) best = sum / weight;
  }
  return best;
}

}  // namespace

void BallFit::add_rolling(const FreeStretch& stretch) {
  Rolling rolling;
  double begins_s = 0;
  double end_mps = 0;
  if (rolls_throughout(stretch)) {
    rolling.deceleration_mps2 = stretch.one.deceleration_mps2;
    const double change_mps = rolling.deceleration_mps2.value * stretch.duration_s();
    rolling.speed_mps = stretch.one.speed_mps - change_mps / 2;
    end_mps = stretch.one.speed_mps - change_mps;
  } else if (slides_then_rolls(stretch)) {
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
  if (measured.deviation < kVagueRolling_mps2 && measured.value > kLeastRolling_mps2 &&
      measured.value < kSlides_mps2 && end_mps > kNearlyAtRest_mps) {
    const auto from = std::lower_bound(stretch.times_s.begin(), stretch.times_s.end(), begins_s);
    rolling.times_s.assign(from, stretch.times_s.end());
    rolling.along_m.assign(stretch.along_m.begin() + (from - stretch.times_s.begin()),
                           stretch.along_m.end());
    rolling_.push_back(std::move(rolling));
  }
}

void BallFit::add(const RecordedMotion& motion) {
  for (const FreeStretch& stretch : free_stretches_in(motion)) {
    if (slides_then_rolls(stretch) && stretch.two->first_mps2.deviation < kVagueSliding_mps2)
      sliding_mps2_.push_back(stretch.two->first_mps2);
    if (slides_throughout(stretch)) sliding_mps2_.push_back(stretch.one.deceleration_mps2);
    add_rolling(stretch);
  }
}

Estimate BallFit::slide_mps2() const {
  return {static_cast<std::int64_t>(sliding_mps2_.size()),
          bootstrap_estimate(sliding_mps2_.size(), kEnoughStretches, kBallSystematic,
                             [&](std::span<const std::size_t> stretches) -> std::optional<double> {
                               std::vector<Measured> chosen;
                               chosen.reserve(stretches.size());
                               for (const std::size_t i : stretches)
                                 chosen.push_back(sliding_mps2_[i]);
                               return robust_mean(chosen, kSlidingSpread_mps2);
                             })};
}

Estimate BallFit::roll_mps2() const {
  return {static_cast<std::int64_t>(rolling_.size()), roll(0)};
}

Estimate BallFit::roll_per_s() const {
  return {static_cast<std::int64_t>(rolling_.size()),
          rolling_.size() >= kEnoughForSlope ? roll(1) : std::nullopt};
}

std::optional<Estimated> BallFit::roll(Eigen::Index parameter) const {
  const bool has_slope = rolling_.size() >= kEnoughForSlope;
  return bootstrap_estimate(rolling_.size(), kEnoughStretches, kBallSystematic,
                            [&](std::span<const std::size_t> stretches) -> std::optional<double> {
                              return rolling_line(rolling_, stretches, has_slope)[parameter];
                            });
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

bool Kick::is_clear() const {
  constexpr double kMostAcross_m = 50_mm;
  constexpr double kMostAngle_rad = 0.35;
  constexpr double kSlowestKick_mps = 1;
  return std::abs(across_m) < kMostAcross_m && std::abs(angle_rad) < kMostAngle_rad &&
         speed_mps > kSlowestKick_mps;
}

std::vector<Kick> kicks_in(const RecordedMotion& motion, const sim::BallParameters& ball) {
  std::vector<Kick> kicks;
  for (const FreeStretch& stretch : free_stretches_in(motion)) {
    if (!slides_then_rolls(stretch) && !slides_throughout(stretch)) continue;
    if (const auto kick = kick_before(motion, stretch, ball)) kicks.push_back(*kick);
  }
  return kicks;
}

Estimate switch_ratio_of(const std::vector<Kick>& kicks) {
  constexpr double kVagueRatio = 0.05;
  std::vector<Measured> ratios;
  for (const Kick& kick : kicks) {
    if (kick.is_clear() && kick.switch_ratio.deviation < kVagueRatio)
      ratios.push_back(kick.switch_ratio);
  }
  return {static_cast<std::int64_t>(ratios.size()),
          bootstrap_estimate(ratios.size(), kEnoughKicks, kBallSystematic,
                             [&](std::span<const std::size_t> chosen) -> std::optional<double> {
                               std::vector<Measured> drawn;
                               drawn.reserve(chosen.size());
                               for (const std::size_t i : chosen) drawn.push_back(ratios[i]);
                               return common_ratio(drawn);
                             })};
}

}  // namespace autoref::logs
