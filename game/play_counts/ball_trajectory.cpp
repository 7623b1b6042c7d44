#include "game/play_counts/ball_trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"

namespace autoref::game {
namespace {

// The distance rolled from `speed_mps` to rest, with deceleration a + k v. Its integral of v dv /
// (a + k v) is v / k - a / k^2 ln(1 + k v / a).
double rolled_m(double speed_mps, const sim::BallParameters& ball) {
  const double a = ball.roll_mps2;
  const double k = ball.roll_per_s;
  if (k * speed_mps < 1e-6 * a) return speed_mps * speed_mps / (2 * a);
  return speed_mps / k - a / (k * k) * std::log1p(k * speed_mps / a);
}

}  // namespace

BallTrajectory::BallTrajectory(const Vec2& from_m, const Vec2& velocity_mps, double vertical_mps,
                               const sim::BallParameters& ball)
    : from_m_(from_m), direction_(direction_of(velocity_mps, {1, 0})), vertical_mps_(vertical_mps) {
  const double kick_mps = velocity_mps.norm();
  double rolls_mps = ball.switch_ratio * kick_mps;
  if (vertical_mps > 0) {
    flight_m_ = kick_mps * 2 * vertical_mps / kGravity_mps2;
    phases_[0] = {kick_mps, 0, flight_m_};
    rolls_mps = ball.hop_first_xy * kick_mps;
  } else {
    const double slides_m = (kick_mps * kick_mps - rolls_mps * rolls_mps) / (2 * ball.slide_mps2);
    phases_[0] = {kick_mps, ball.slide_mps2, slides_m};
  }
  phases_[1] = {rolls_mps, ball.roll_mps2, rolled_m(rolls_mps, ball)};
  if (ball.roll_per_s > 0)
    phases_[1].slowing_mps2 = rolls_mps * rolls_mps / (2 * phases_[1].length_m);
}

double BallTrajectory::Phase::speed_at_mps(double path_m) const {
  return std::sqrt(std::max(0.0, speed_mps * speed_mps - 2 * slowing_mps2 * path_m));
}

// With constant deceleration, the mean speed is the average of the first and the last one.
double BallTrajectory::Phase::time_at_s(double path_m) const {
  return path_m <= 0 ? 0 : 2 * path_m / (speed_mps + speed_at_mps(path_m));
}

double BallTrajectory::speed_mps(double path_m) const {
  const double first_m = phases_[0].length_m;
  return path_m < first_m ? phases_[0].speed_at_mps(path_m)
                          : phases_[1].speed_at_mps(path_m - first_m);
}

double BallTrajectory::time_s(double path_m) const {
  const double first_m = std::min(path_m, phases_[0].length_m);
  return phases_[0].time_at_s(first_m) + phases_[1].time_at_s(path_m - first_m);
}

double BallTrajectory::height_m(double path_m) const {
  if (path_m >= flight_m_) return 0;
  const double flown_s = phases_[0].time_at_s(path_m);
  return vertical_mps_ * flown_s - kGravity_mps2 * flown_s * flown_s / 2;
}

}  // namespace autoref::game
