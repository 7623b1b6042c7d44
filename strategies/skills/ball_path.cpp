#include "strategies/skills/ball_path.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"

namespace autoref::strategies {
namespace {

constexpr double kSlide_mps2 = 3.4;
constexpr double kRoll_mps2 = 0.30;
constexpr double kRollsFrom = 0.67;  // fraction of the kick speed
constexpr double kPathStill_mps = 0.03;
constexpr double kPeak_mps = 0.15;  // speed gain per frame that indicates a kick
constexpr double kNever_s = 10;

// Duration and length of the sliding phase from `speed_mps` down to `rolls_mps`.
struct Phase {
  double time_s = 0;
  double path_m = 0;
};
Phase sliding(double speed_mps, double rolls_mps) {
  const double time_s = std::max(0.0, (speed_mps - rolls_mps) / kSlide_mps2);
  return {time_s, time_s * (speed_mps + rolls_mps) / 2};
}

double rolled_m(double speed_mps, double time_s) {
  const double t = std::min(time_s, speed_mps / kRoll_mps2);
  return speed_mps * t - kRoll_mps2 * t * t / 2;
}

// `slide` is the phase from `speed_mps` down to `rolling_mps`.
double path_after_m(double speed_mps, double rolling_mps, const Phase& slide, double time_s) {
  if (time_s < slide.time_s) return speed_mps * time_s - kSlide_mps2 * time_s * time_s / 2;
  return slide.path_m + rolled_m(rolling_mps, time_s - slide.time_s);
}

double speed_after_mps(double speed_mps, double rolling_mps, const Phase& slide, double time_s) {
  if (time_s < slide.time_s) return speed_mps - kSlide_mps2 * time_s;
  return std::max(0.0, rolling_mps - kRoll_mps2 * (time_s - slide.time_s));
}

}  // namespace

void BallPath::follow(const TrackedBall& ball, double latency_s) {
  const double seen_mps = ball.velocity_mps.norm();
  // The kick speed determines when sliding ends. A jump in speed means a new kick. Once the ball
  // rolls, kick_mps_ shrinks with the ball's speed, so that a softer kick is detected as well.
  if (seen_mps > last_mps_ + kPeak_mps || seen_mps > kick_mps_) kick_mps_ = seen_mps;
  if (seen_mps < kRollsFrom * kick_mps_) kick_mps_ = seen_mps / kRollsFrom;  // it is rolling
  last_mps_ = seen_mps;
  direction_ = direction_of(ball.velocity_mps, direction_);
  const double rolling_mps = std::min(seen_mps, kRollsFrom * kick_mps_);
  const Phase slide = sliding(seen_mps, rolling_mps);
  const bool is_still = seen_mps < kPathStill_mps;
  speed_mps_ = is_still ? 0 : speed_after_mps(seen_mps, rolling_mps, slide, latency_s);
  for (int i = 0; i <= kSteps; ++i) {
    const double path_m =
        is_still ? 0 : path_after_m(seen_mps, rolling_mps, slide, latency_s + i * kStep_s);
    table_[static_cast<std::size_t>(i)] = ball.position_m + direction_ * path_m;
  }
}

double kick_for_mps(double distance_m, double arrival_mps) {
  // If the ball arrives rolling: v_roll^2 = arrival^2 + 2 a (distance - slide), slide = k v0^2.
  constexpr double kSlidePerSpeed2 = (1 - kRollsFrom * kRollsFrom) / (2 * kSlide_mps2);
  constexpr double kShare = kRollsFrom * kRollsFrom + 2 * kRoll_mps2 * kSlidePerSpeed2;
  const double kick2 = (arrival_mps * arrival_mps + 2 * kRoll_mps2 * distance_m) / kShare;
  if (kSlidePerSpeed2 * kick2 <= distance_m) return std::sqrt(kick2);
  return std::sqrt(arrival_mps * arrival_mps + 2 * kSlide_mps2 * distance_m);  // still sliding
}

KickedBall::KickedBall(double kick_mps) : kick_mps_(kick_mps), rolls_mps_(kRollsFrom * kick_mps) {
  const Phase slide = sliding(kick_mps, rolls_mps_);
  slide_s_ = slide.time_s;
  slide_m_ = slide.path_m;
}

// Solves s = v t - a t^2 / 2 for t in the phase in which the ball covers the distance.
double KickedBall::roll_time_s(double distance_m) const {
  if (distance_m <= slide_m_) {
    const double left2 = kick_mps_ * kick_mps_ - 2 * kSlide_mps2 * distance_m;
    return (kick_mps_ - std::sqrt(std::max(0.0, left2))) / kSlide_mps2;
  }
  const double left2 = rolls_mps_ * rolls_mps_ - 2 * kRoll_mps2 * (distance_m - slide_m_);
  if (left2 < 0) return kNever_s;
  return slide_s_ + (rolls_mps_ - std::sqrt(left2)) / kRoll_mps2;
}

}  // namespace autoref::strategies
