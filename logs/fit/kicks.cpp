#include "logs/fit/kicks.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "logs/fit/free_stretches.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kLeavesPlate_m = 3_mm;  // a ball this far from the plate has left it
// The ball is followed back from the first detection for at most this time, in such steps.
constexpr double kLongestRunBack_s = 0.35;
constexpr int kStepsPerFrame = 4;

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
  if (stretch.slides_then_rolls()) {
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
  if (!stretch.slides_then_rolls())
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

double direction_error_rad(const FreeStretch& stretch) {
  const Eigen::Map<const Eigen::ArrayXd> along_m(stretch.along_m.data(),
                                                 std::ssize(stretch.along_m));
  return stretch.noise_m / std::sqrt((along_m - along_m.mean()).square().sum());
}

std::optional<Kick> kick_before(const RecordedMotion& motion, const FreeStretch& stretch,
                                const sim::BallParameters& ball) {
  const bool has_switch = stretch.slides_then_rolls();
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
  kick.direction_error_rad = direction_error_rad(stretch);
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
                                    ratio / kick.speed_mps * ball.slide_mps2 * kKickTimeError_s)};
  }
  return kick;
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
    if (!stretch.slides_then_rolls() && !stretch.slides_throughout()) continue;
    if (const auto kick = kick_before(motion, stretch, ball)) kicks.push_back(*kick);
  }
  return kicks;
}

Estimate switch_ratio_of(const std::vector<Kick>& kicks) {
  constexpr double kVagueRatio = 0.05;
  constexpr std::size_t kEnoughKicks = 5;
  constexpr double kSystematic = 0.01;  // share of the estimate
  std::vector<Measured> ratios;
  for (const Kick& kick : kicks) {
    if (kick.is_clear() && kick.switch_ratio.deviation < kVagueRatio)
      ratios.push_back(kick.switch_ratio);
  }
  return {static_cast<std::int64_t>(ratios.size()),
          bootstrap_estimate(ratios.size(), kEnoughKicks, kSystematic,
                             [&](std::span<const std::size_t> indices) -> std::optional<double> {
                               return common_ratio(elements_at(ratios, indices));
                             })};
}

}  // namespace autoref::logs
