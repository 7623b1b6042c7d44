#include "logs/fit/rest_drift.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "logs/fit/sights.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kRestWindow_s = 0.25;
constexpr std::size_t kFewestRestWindows = 12;
constexpr double kSeenInWindow = 0.75;  // share of its frames
// An object rests as long as its mean poses stay this near to the first.
constexpr double kRestRadius_m = 5_mm;
constexpr double kRestTurn_rad = 0.05;

double heading_rad_of(const RobotSight& sight) { return sight.heading_rad; }
double heading_rad_of(const BallSight& /*sight*/) { return 0; }

struct RestWindow {
  Vec2 position_m{0, 0};
  double heading_rad = 0;
  std::uint32_t camera = 0;
  double sights = 0;
  double square_m2 = 0;  // sum of the squared lengths of third differences
  double differences = 0;
  bool is_usable = false;
};

template <typename Sight>
RestWindow window_of(std::span<const Sight> sights) {
  RestWindow window;
  window.camera = sights.front().camera;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (!sights[i].is_seen) continue;
    if (sights[i].camera != window.camera) return window;
    window.position_m += sights[i].position_m;
    window.heading_rad += heading_rad_of(sights[i]);
    ++window.sights;
    if (i + 1 < kThirdDifferenceValues) continue;
    const auto four = sights.subspan(i + 1 - kThirdDifferenceValues, kThirdDifferenceValues);
    if (!is_seen_by_one_camera(four)) continue;
    window.square_m2 += third_difference_m(four).squaredNorm();
    ++window.differences;
  }
  window.position_m /= std::max(window.sights, 1.0);
  window.heading_rad /= std::max(window.sights, 1.0);
  window.is_usable = window.sights >= kSeenInWindow * static_cast<double>(sights.size());
  return window;
}

bool is_same_rest(const RestWindow& first, const RestWindow& window) {
  return window.is_usable && window.camera == first.camera &&
         (window.position_m - first.position_m).norm() <= kRestRadius_m &&
         std::abs(window.heading_rad - first.heading_rad) <= kRestTurn_rad;
}

double drift_m2(std::span<const RestWindow> rest) {
  Vec2 mean_m(0, 0);
  double square_m2 = 0;
  double differences = 0;
  double inverse_sights = 0;
  for (const RestWindow& window : rest) {
    mean_m += window.position_m;
    square_m2 += window.square_m2;
    differences += window.differences;
    inverse_sights += 1 / window.sights;
  }
  const auto windows = static_cast<double>(rest.size());
  mean_m /= windows;
  double between_m2 = 0;
  for (const RestWindow& window : rest) between_m2 += (window.position_m - mean_m).squaredNorm();
  constexpr double kAxes = 2;
  const double noise_m2 =
      square_m2 / (kAxes * kThirdDifferenceVariance * std::max(differences, 1.0));
  return between_m2 / (kAxes * (windows - 1)) - noise_m2 * inverse_sights / windows;
}

// The object may have moved in the first and the last window of a row, so they are left out.
template <typename Sight>
std::vector<double> drifts_m2(const std::vector<Sight>& sights, double interval_s) {
  const auto length = std::max(kThirdDifferenceValues,
                               static_cast<std::size_t>(std::lround(kRestWindow_s / interval_s)));
  std::vector<RestWindow> row;
  std::vector<double> drifts;
  const auto end_row = [&] {
    if (row.size() >= kFewestRestWindows + 2)
      drifts.push_back(drift_m2(std::span(row).subspan(1, row.size() - 2)));
    row.clear();
  };
  for (std::size_t i = 0; i + length <= sights.size(); i += length) {
    const RestWindow window = window_of(std::span(sights).subspan(i, length));
    if (!row.empty() && !is_same_rest(row.front(), window)) end_row();
    if (window.is_usable) row.push_back(window);
  }
  end_row();
  return drifts;
}

}  // namespace

std::vector<double> ball_drifts_m2(const RecordedMotion& motion) {
  return drifts_m2(motion.ball, motion.interval_s);
}

std::vector<double> robot_drifts_m2(const RecordedMotion& motion, const RobotMotion& robot) {
  return drifts_m2(robot.sights, motion.interval_s);
}

}  // namespace autoref::logs
