#include "referee/touch/velocity_change_detector.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::referee {
namespace {

// Noise in two coordinates exceeds this many standard deviations once in 270 000 detections, by the
// tail of the Rayleigh distribution, exp(-5^2 / 2).
constexpr double kChangeDeviations = 5.0;

}  // namespace

VelocityChangeDetector::Line VelocityChangeDetector::line_through(int newest_back,
                                                                  int oldest_back) const {
  const double count = oldest_back - newest_back + 1;
  Line line;
  for (int back = newest_back; back <= oldest_back; ++back) {
    line.middle_s += ball(back).time_s / count;
    line.middle_m += ball(back).position_m / count;
  }
  double spread_s2 = 0;
  Vec2 slope_ms(0, 0);
  for (int back = newest_back; back <= oldest_back; ++back) {
    const double away_s = ball(back).time_s - line.middle_s;
    spread_s2 += away_s * away_s;
    slope_ms += away_s * (ball(back).position_m - line.middle_m);
  }
  line.velocity_mps = slope_ms / spread_s2;
  line.variance_m2ps2 = parameters_.position_noise_m * parameters_.position_noise_m / spread_s2;
  return line;
}

std::optional<VelocityChange> VelocityChangeDetector::update() {
  known_ = std::min(known_ + 1, kUsed);
  if (known_ < kUsed) {
    former_excess_ = 0;
    return std::nullopt;
  }
  const Line after = line_through(0, kHalf);
  const Line before = line_through(kHalf, 2 * kHalf);
  const Vec2 change_mps = unexplained_change_mps(before, after);
  const double noise_mps = std::sqrt(after.variance_m2ps2 + before.variance_m2ps2);
  const double excess = change_mps.norm() / (kChangeDeviations * noise_mps);
  const bool is_past_peak = former_excess_ > 1 && excess < former_excess_;
  std::optional<VelocityChange> found;
  if (is_past_peak) {
    found = former_;
    found->before = &frames_.detection(kHalf + 2);
    found->after = &frames_.detection(kHalf);
  }
  former_.since_s = ball(2 * kHalf).time_s;
  former_.segment = {before.at(ball(kHalf + 1).time_s), after.at(ball(kHalf - 1).time_s)};
  former_.impulse = {change_mps, after.velocity_mps};
  former_excess_ = is_past_peak ? 0 : excess;
  return found;
}

// The velocity change minus the deceleration that friction can explain.
Vec2 VelocityChangeDetector::unexplained_change_mps(const Line& before, const Line& after) const {
  const Vec2 change_mps = after.velocity_mps - before.velocity_mps;
  const double carpet_mps = parameters_.carpet_mps2 * (after.middle_s - before.middle_s);
  const Vec2 forwards = direction_of(before.velocity_mps, Vec2(0, 0));
  const double lost_mps = std::clamp(-change_mps.dot(forwards), 0.0, carpet_mps);
  return change_mps + lost_mps * forwards;
}

}  // namespace autoref::referee
