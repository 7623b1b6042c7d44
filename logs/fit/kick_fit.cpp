#include "logs/fit/kick_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "logs/third_differences.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// A robot's motion at the time of a kick.
struct KickingRobot {
  double heading_rad = 0;
  double turning_radps = 0;
  Vec2 velocity_mps{0, 0};
  double headings = 0;  // variance of the heading / that of a detected heading
};

// Polynomials of heading, x and y over the time since the kick.
struct PoseFit {
  Eigen::MatrixX3d coefficients;  // row k: of the k-th power
  double variance = 0;            // of the first row / that of a detection
};

// Fits polynomials of `powers` coefficients to the robot's detections in `frames`.
PoseFit pose_fit(const RecordedMotion& motion, const Kick& kick,
                 std::span<const std::size_t> frames, Eigen::Index powers) {
  const auto& sights = motion.robots[kick.robot].sights;
  const auto n = static_cast<Eigen::Index>(frames.size());
  Eigen::MatrixXd rows(n, powers);
  Eigen::MatrixX3d values(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = frames[static_cast<std::size_t>(k)];
    const double since_s = sights[i].time_s - kick.time_s;
    for (Eigen::Index power = 0; power < rows.cols(); ++power)
      rows(k, power) = std::pow(since_s, power);
    values.row(k) << sights[i].heading_rad, sights[i].position_m.transpose();
  }
  const Eigen::MatrixXd inverse =
      (rows.transpose() * rows).ldlt().solve(Eigen::MatrixXd(rows.transpose()));
  return {inverse * values, inverse.row(0).squaredNorm()};
}

// The heading comes from the last detections before the kick, since robots may begin to turn as
// soon as they have kicked; velocities come from detections on both sides of it.
std::optional<KickingRobot> kicking_robot(const RecordedMotion& motion, const Kick& kick) {
  constexpr std::size_t kFramesBefore = 4;
  constexpr std::size_t kFramesAfter = 5;
  constexpr std::size_t kFewestSights = 5;
  constexpr std::size_t kSightsForParabola = 7;
  constexpr std::size_t kSightsForHeading = 3;
  const auto& sights = motion.robots[kick.robot].sights;
  const std::size_t frame = motion.frame_at(kick.time_s);
  std::vector<std::size_t> seen;
  std::size_t before = 0;  // the number of those until the kick
  for (std::size_t i = frame - std::min(frame, kFramesBefore);
       i <= frame + kFramesAfter && i < motion.frames(); ++i) {
    if (!sights[i].is_seen) continue;
    seen.push_back(i);
    if (i <= frame) ++before;
  }
  if (seen.size() < kFewestSights || before < kSightsForHeading) return std::nullopt;
  const PoseFit around = pose_fit(motion, kick, seen, seen.size() < kSightsForParabola ? 2 : 3);
  const PoseFit until = pose_fit(
      motion, kick, std::span(seen).subspan(before - kSightsForHeading, kSightsForHeading), 2);
  return KickingRobot{until.coefficients(0, 0), around.coefficients(1, 0),
                      around.coefficients.row(1).tail<2>().transpose(), until.variance};
}

// How the ball moves before a kick.
struct HeldBall {
  Vec2 velocity_mps{0, 0};
  double variance_ps2 = 0;  // of each component / that of a detection
};

// From the last detections before the kick, all of which must show the ball at the plate.
std::optional<HeldBall> held_before(const RecordedMotion& motion, const Kick& kick) {
  constexpr std::size_t kFrames = 10;
  constexpr int kMostSights = 5;
  constexpr int kFewestSights = 4;
  constexpr int kSightsForVelocity = 3;
  constexpr double kFromPlate_m = 16_mm;
  constexpr double kNoises = 3;
  const std::size_t last = motion.frame_at(kick.time_s);
  Eigen::Matrix2d rows = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d values = Eigen::Matrix2d::Zero();
  int sights = 0;
  for (std::size_t back = 0; back < std::min(kFrames, last + 1) && sights < kMostSights; ++back) {
    const BallSight& ball = motion.ball[last - back];
    if (!ball.is_seen) continue;
    const RobotSight robot = motion.robot_at(kick.robot, ball.time_s);
    const Vec2 from_robot_m = ball.position_m - robot.position_m;
    const Vec2 ball_m = to_local(from_robot_m, heading_of(robot.heading_rad));
    if (!robot.is_known || std::abs(ball_m.y()) > kHalfPlate_m ||
        ball_m.x() > kPlateTouch_m + kFromPlate_m + kNoises * motion.ball_noise_m)
      return std::nullopt;
    if (++sights > kSightsForVelocity) continue;
    const Eigen::Vector2d row(1, ball.time_s - kick.time_s);
    rows += row * row.transpose();
    values += row * ball.position_m.transpose();
  }
  if (sights < kFewestSights) return std::nullopt;
  const Eigen::Matrix2d inverse = rows.inverse();
  return HeldBall{(inverse * values).row(1).transpose(), inverse(1, 1)};
}

// A kicked ball keeps its speed across the robot's heading, so that speed is subtracted. It is the
// weighted mean of the ball's own and the plate's, which hardly slides under a held ball.
std::optional<KickAngle> kick_angle(const RecordedMotion& motion, const Kick& kick) {
  constexpr double kSlowest_mps = 1.5;
  constexpr double kFarthestAcross_m = 45_mm;
  constexpr double kMostAngle_rad = 0.6;
  // The weight of the ball's speed, and the error of that mean beyond vision's noise, as the ball
  // still accelerates before the kick. Both are fitted to simulated kicks.
  constexpr double kOfBall = 0.65;
  constexpr double kSpeedError_mps = 0.05;
  constexpr double kLargestError_rad = 0.1;
  constexpr double kMostHeadings = 10;
  if (kick.speed_mps < kSlowest_mps || std::abs(kick.across_m) > kFarthestAcross_m ||
      std::abs(kick.angle_rad) > kMostAngle_rad)
    return std::nullopt;
  const auto held = held_before(motion, kick);
  const auto robot = held ? kicking_robot(motion, kick) : std::nullopt;
  if (!robot) return std::nullopt;
  const Vec2 heading = heading_of(robot->heading_rad);
  const Vec2 kick_mps = to_local(kick.speed_mps * kick.direction, heading);
  const double plate_mps =
      to_local(robot->velocity_mps, heading).y() + robot->turning_radps * kPlateTouch_m;
  const double across_mps =
      kOfBall * to_local(held->velocity_mps, heading).y() + (1 - kOfBall) * plate_mps;
  const double speed_error2 =
      square(kSpeedError_mps) + square(kOfBall * motion.ball_noise_m) * held->variance_ps2;
  const KickAngle angle{std::atan2(kick_mps.y() - across_mps, kick_mps.x()),
                        speed_error2 / square(kick_mps.x()) + square(kick.direction_error_rad) +
                            square(robot->turning_radps * kKickTimeError_s),
                        robot->headings};
  // Detections at nearly the same time say nothing about speeds and headings.
  const bool is_usable = std::isfinite(angle.off_rad) && std::abs(angle.off_rad) < kMostAngle_rad &&
                         angle.error_rad2 < square(kLargestError_rad) &&
                         angle.headings < kMostHeadings;
  return is_usable ? std::optional(angle) : std::nullopt;
}

struct Variances {
  double all_rad2 = 0;        // of the kicks' directions
  double measuring_rad2 = 0;  // what errors of measurement add to it
};

// Without outliers, such as deflections. Starts from the median of the distances from the median.
Variances variances_of(const std::vector<KickAngle>& angles, double robot_noise_rad) {
  constexpr int kRounds = 10;
  constexpr double kFarthest = 2.7;          // in standard deviations
  constexpr double kVarianceWithin = 0.943;  // of a normal distribution cut off there
  std::vector<double> values;
  values.reserve(angles.size());
  for (const KickAngle& angle : angles) values.push_back(angle.off_rad);
  double mean = median(values);
  for (double& value : values) value = std::abs(value - mean);
  double variance = square(median(values) / kNormalMedian);
  double measuring = 0;
  for (int round = 0; round < kRounds; ++round) {
    double n = 0;
    double sum = 0;
    double squares = 0;
    double errors = 0;
    for (const KickAngle& angle : angles) {
      const double off_rad = angle.off_rad - mean;
      if (square(off_rad) > square(kFarthest) * variance) continue;
      ++n;
      sum += off_rad;
      squares += square(off_rad);
      errors += angle.error_rad2 + angle.headings * square(robot_noise_rad);
    }
    if (n < 2) break;
    mean += sum / n;
    variance = (squares - square(sum) / n) / (n - 1) / kVarianceWithin;
    measuring = errors / n;
  }
  return {variance, measuring};
}

}  // namespace

void KickFit::add(const RecordedMotion& motion, std::span<const Kick> kicks) {
  for (const Kick& kick : kicks) {
    if (const auto angle = kick_angle(motion, kick)) angles_.push_back(*angle);
  }
}

// The upper bound of the interval does not rely on the errors of measurement.
Estimate KickFit::direction_noise_deg(double robot_noise_rad) const {
  constexpr std::size_t kEnough = 12;
  constexpr double kSystematic = 0.1;  // simulated games show a bias of 4 %
  Estimate estimate{static_cast<std::int64_t>(angles_.size()), std::nullopt};
  const auto deg = [](double variance_rad2) {
    return std::sqrt(std::max(variance_rad2, 0.0)) / to_radians(1);
  };
  const auto numbers = bootstrap_estimates(
      angles_.size(), kEnough, {kSystematic, kSystematic},
      [&](std::span<const std::size_t> kicks) -> std::optional<std::vector<double>> {
        const Variances found = variances_of(elements_at(angles_, kicks), robot_noise_rad);
        return std::vector{deg(found.all_rad2 - found.measuring_rad2), deg(found.all_rad2)};
      });
  if (numbers) {
    estimate.number = numbers->front();
    estimate.number->high = numbers->back().high;
  }
  return estimate;
}

}  // namespace autoref::logs
