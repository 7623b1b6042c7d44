#include "logs/fit/rig_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kFreely = 0.05;  // of an interval
// A robot rests while it stays within this distance; a rest is one episode for at most this time.
constexpr double kStays_m = 5_mm;
constexpr double kLongestRest_s = 2;
constexpr int kFewestSights = 10;  // of a rest, so that noise averages out
constexpr std::size_t kEnough = 10;
constexpr std::size_t kMostDisagreements = 100'000;
// When another camera takes over a robot, straight lines through this many sights on both sides
// show the jump. The robot is slow, as the cameras' clocks may differ by 10 ms
// (league/camera_clocks.hpp).
constexpr std::size_t kHandoverSights = 6;
constexpr double kSlow_mps = 1;
constexpr double kOtherRobot_m = 0.1;  // farther away, a robot's number was misread

// The differences between two cameras' sights of a robot that rests.
struct Rest {
  double begins_s = 0;
  Vec2 position_m{0, 0};
  Vec2 sum_m{0, 0};
  int sights = 0;
};

// Where the robot is at `time_s` according to a line through its sights from frame `first` on;
// nullopt if these are not by one camera and complete, or if the robot is fast.
std::optional<Vec2> position_at(double time_s, const RobotMotion& robot, std::size_t first) {
  Eigen::Matrix2d rows = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d values = Eigen::Matrix2d::Zero();
  for (std::size_t i = first; i < first + kHandoverSights; ++i) {
    const RobotSight& sight = robot.sights[i];
    if (!sight.is_seen || sight.camera != robot.sights[first].camera) return std::nullopt;
    const Eigen::Vector2d row(1, sight.time_s - time_s);
    rows += row * row.transpose();
    values += row * sight.position_m.transpose();
  }
  const Eigen::Matrix2d line = rows.inverse() * values;
  if (line.row(1).norm() > kSlow_mps) return std::nullopt;
  return Vec2(line.row(0).transpose());
}

}  // namespace

void RigFit::add(const RecordedMotion& motion) {
  add_captures(motion);
  add_rests(motion);
  for (const RobotMotion& robot : motion.robots) add_handovers(motion, robot);
}

void RigFit::add_captures(const RecordedMotion& motion) {
  constexpr std::size_t kFewestCaptures = 2;
  const std::vector<double>* reference_s = nullptr;
  for (const auto& [camera, times_s] : motion.captures_s) {
    if (times_s.size() < kFewestCaptures) continue;
    Captures& captures = captures_[camera];
    const double interval_s = median_step(times_s);
    captures.captures += static_cast<std::int64_t>(times_s.size());
    captures.intervals_s.push_back(interval_s);
    if (reference_s == nullptr) reference_s = &times_s;
    for (const double time_s : times_s) {
      const auto after = std::upper_bound(reference_s->begin(), reference_s->end(), time_s);
      if (after == reference_s->begin()) continue;
      const double angle_rad = 2 * M_PI * (time_s - *(after - 1)) / interval_s;
      captures.cosines += std::cos(angle_rad);
      captures.sines += std::sin(angle_rad);
      ++captures.compared;
    }
  }
}

void RigFit::note_disagreement(const Vec2& difference_m) {
  if (difference_m.norm() < kOtherRobot_m && disagreements_m2_.size() < kMostDisagreements)
    disagreements_m2_.push_back(difference_m.squaredNorm());
}

void RigFit::add_rests(const RecordedMotion& motion) {
  std::map<std::tuple<Side, int, std::uint32_t, std::uint32_t>, Rest> rests;
  const auto finish = [&](Rest& rest) {
    if (rest.sights >= kFewestSights) note_disagreement(rest.sum_m / rest.sights);
    rest = {};
  };
  for (const DoubleSight& sight : motion.double_sights) {
    Rest& rest = rests[{sight.id.side, sight.id.number, sight.first_camera, sight.second_camera}];
    const auto robot =
        std::find_if(motion.robots.begin(), motion.robots.end(),
                     [&](const RobotMotion& candidate) { return candidate.id == sight.id; });
    if (robot == motion.robots.end()) continue;
    const Vec2& position_m = robot->sights[sight.frame].position_m;
    const double time_s = motion.times_s[sight.frame];
    if ((position_m - rest.position_m).norm() > kStays_m || time_s - rest.begins_s > kLongestRest_s)
      finish(rest);
    if (rest.sights == 0) rest = {time_s, position_m};
    rest.sum_m += sight.difference_m;
    ++rest.sights;
  }
  for (auto& [key, rest] : rests) finish(rest);
}

void RigFit::add_handovers(const RecordedMotion& motion, const RobotMotion& robot) {
  for (std::size_t i = kHandoverSights; i + kHandoverSights <= motion.frames(); ++i) {
    if (robot.sights[i].camera == robot.sights[i - 1].camera) continue;
    const double time_s = (robot.sights[i - 1].time_s + robot.sights[i].time_s) / 2;
    const auto before = position_at(time_s, robot, i - kHandoverSights);
    const auto after = position_at(time_s, robot, i);
    if (before && after) note_disagreement(*after - *before);
  }
}

std::map<std::uint32_t, CameraTiming> RigFit::cameras() const {
  std::map<std::uint32_t, CameraTiming> timings;
  for (const auto& [camera, captures] : captures_) {
    const double interval_s = median(captures.intervals_s);
    CameraTiming timing{captures.captures, 1 / interval_s, {}};
    if (captures.compared > 0) {
      const double length =
          std::hypot(captures.cosines, captures.sines) / static_cast<double>(captures.compared);
      const double turn_s = interval_s / (2 * M_PI);
      timing.phase_s = {turn_s * std::atan2(captures.sines, captures.cosines),
                        turn_s * std::sqrt(2 * std::max(-std::log(length), 0.0))};
    }
    timings[camera] = timing;
  }
  return timings;
}

bool RigFit::cameras_run_freely() const {
  const auto timings = cameras();
  const auto is_free = [](const CameraTiming& one, const CameraTiming& other) {
    const double apart = (one.phase_s.value - other.phase_s.value) * one.rate_hz;
    return std::abs(std::remainder(apart, 1.0)) > kFreely ||
           one.phase_s.deviation * one.rate_hz > kFreely;
  };
  for (const auto& [number, one] : timings) {
    for (const auto& [other_number, other] : timings) {
      if (number != other_number && is_free(one, other)) return true;
    }
  }
  return false;
}

Estimate RigFit::camera_error_m() const {
  constexpr double kSystematic = 0.05;
  // Cameras meet at seams, where a simulated camera's error is 0.51 to 1.47 times its root mean
  // square over the field, in 95 % of games (sim::CameraErrors with random phases).
  constexpr double kLeastAtSeam = 0.51;
  constexpr double kMostAtSeam = 1.47;
  Estimate estimate{static_cast<std::int64_t>(disagreements_m2_.size()), {}};
  estimate.number =
      bootstrap_estimate(disagreements_m2_.size(), kEnough, kSystematic,
                         [&](std::span<const std::size_t> rests) -> std::optional<double> {
                           double sum_m2 = 0;
                           for (const std::size_t i : rests) sum_m2 += disagreements_m2_[i];
                           return std::sqrt(sum_m2 / static_cast<double>(rests.size())) / 2;
                         });
  if (estimate.number) {
    estimate.number->low /= kMostAtSeam;
    estimate.number->high /= kLeastAtSeam;
  }
  return estimate;
}

}  // namespace autoref::logs
