#include "logs/fit/kick_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

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
  double heading_factor = 0;  // standard deviation of the heading / that of a detected heading
};

// Fits parabolas, or lines if there are few detections, to the detections around the kick.
std::optional<KickingRobot> kicking_robot(const RecordedMotion& motion, const Kick& kick) {
  constexpr std::size_t kFramesBefore = 4;
  constexpr std::size_t kFramesAfter = 5;
  constexpr std::size_t kFewestSights = 5;
  constexpr std::size_t kSightsForParabola = 7;
  const auto& sights = motion.robots[kick.robot].sights;
  const std::size_t frame = motion.frame_at(kick.time_s);
  std::vector<std::size_t> seen;
  for (std::size_t i = frame - std::min(frame, kFramesBefore);
       i <= frame + kFramesAfter && i < motion.frames(); ++i) {
    if (sights[i].is_seen) seen.push_back(i);
  }
  if (seen.size() < kFewestSights) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(seen.size());
  Eigen::MatrixXd rows(n, seen.size() < kSightsForParabola ? 2 : 3);
  Eigen::MatrixX3d values(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = seen[static_cast<std::size_t>(k)];
    const double since_s = motion.times_s[i] - kick.time_s;
    for (Eigen::Index power = 0; power < rows.cols(); ++power)
      rows(k, power) = std::pow(since_s, power);
    values.row(k) << sights[i].heading_rad, sights[i].position_m.transpose();
  }
  const Eigen::MatrixXd inverse =
      (rows.transpose() * rows).ldlt().solve(Eigen::MatrixXd(rows.transpose()));
  const Eigen::MatrixX3d fit = inverse * values;
  return KickingRobot{fit(0, 0), fit(1, 0), fit.row(1).tail<2>().transpose(),
                      inverse.row(0).norm()};
}

// Whether the last detections before the kick show the ball at the plate.
bool is_held_before(const RecordedMotion& motion, const Kick& kick) {
  constexpr std::size_t kFrames = 10;
  constexpr int kMostSights = 5;
  constexpr int kFewestSights = 4;
  constexpr double kReach_m = 16_mm;
  constexpr double kNoises = 3;
  const std::size_t last = motion.frame_at(kick.time_s);
  int sights = 0;
  for (std::size_t back = 0; back < std::min(kFrames, last + 1) && sights < kMostSights; ++back) {
    const std::size_t i = last - back;
    if (!motion.ball[i].is_seen) continue;
    ++sights;
    const RobotSight& robot = motion.robots[kick.robot].sights[i];
    const Vec2 ball_m =
        to_local(motion.ball[i].position_m - robot.position_m, heading_of(robot.heading_rad));
    if (!robot.is_known || std::abs(ball_m.y()) > kHalfPlate_m ||
        ball_m.x() > kPlateTouch_m + kReach_m + kNoises * motion.ball_noise_m)
      return false;
  }
  return sights >= kFewestSights;
}

std::optional<KickAngle> kick_angle(const RecordedMotion& motion, const Kick& kick) {
  constexpr double kSlowest_mps = 1.5;
  constexpr double kFarthestAcross_m = 45_mm;
  constexpr double kMostAngle_rad = 0.6;
  if (kick.speed_mps < kSlowest_mps || std::abs(kick.across_m) > kFarthestAcross_m ||
      std::abs(kick.angle_rad) > kMostAngle_rad || !is_held_before(motion, kick))
    return std::nullopt;
  const auto robot = kicking_robot(motion, kick);
  if (!robot) return std::nullopt;
  const Vec2 heading = heading_of(robot->heading_rad);
  const Vec2 ball_mps = to_local(kick.speed_mps * kick.direction, heading);
  const double plate_mps =
      to_local(robot->velocity_mps, heading).y() + robot->turning_radps * kPlateTouch_m;
  return KickAngle{std::atan2(ball_mps.y() - plate_mps, ball_mps.x()), robot->heading_factor};
}

// The variance of the kicks' directions without errors of measurement and without outliers, such
// as deflections. It starts from the median of the distances from the median.
double direction_variance_rad2(const std::vector<KickAngle>& angles, double robot_noise_rad) {
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
    double factors = 0;
    for (const KickAngle& angle : angles) {
      const double off_rad = angle.off_rad - mean;
      if (square(off_rad) > square(kFarthest) * variance) continue;
      ++n;
      sum += off_rad;
      squares += square(off_rad);
      factors += square(angle.heading_factor);
    }
    if (n < 2) break;
    mean += sum / n;
    variance = (squares - square(sum) / n) / (n - 1) / kVarianceWithin;
    measuring = factors / n * square(robot_noise_rad);
  }
  return std::max(0.0, variance - measuring);
}

}  // namespace

void KickFit::add(const RecordedMotion& motion, std::span<const Kick> kicks) {
  for (const Kick& kick : kicks) {
    if (const auto angle = kick_angle(motion, kick)) angles_.push_back(*angle);
  }
}

Estimate KickFit::direction_noise_deg(double robot_noise_rad) const {
  constexpr std::size_t kEnough = 12;
  // Simulated games show about a tenth too much, as the ball does not quite move with the plate.
  constexpr double kSystematic = 0.15;
  return {static_cast<std::int64_t>(angles_.size()),
          bootstrap_estimate(angles_.size(), kEnough, kSystematic,
                             [&](std::span<const std::size_t> kicks) -> std::optional<double> {
                               std::vector<KickAngle> chosen;
                               chosen.reserve(kicks.size());
                               for (const std::size_t i : kicks) chosen.push_back(angles_[i]);
                               return std::sqrt(direction_variance_rad2(chosen, robot_noise_rad)) /
                                      to_radians(1);
                             })};
}

}  // namespace autoref::logs
