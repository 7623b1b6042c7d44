#include "referee/rules/kick_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/ball_out.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr std::size_t kIntervals = 3;
// Standard deviations that a speed must be beyond the limit.
constexpr double kBeyondNoise = 2;
// What every carpet of the league takes from a kicked ball, at least: it slides at first.
constexpr double kCarpet_mps2 = 3.0;

struct Speed {
  double mps = 0;
  double deviation_mps = 0;
};

// The mean speed between two sightings; in space, the speed that the ball had on the ground.
Speed mean_speed(const RecentBall& from, const RecentBall& to, const Configuration& c) {
  const double duration_s = to.time_s - from.time_s;
  Speed speed{(to.position_m - from.position_m).norm() / duration_s,
              std::sqrt(2.0) * c.noise.ball_m / duration_s};
  if (c.rules.edition != Edition::kRules2026) return speed;
  const double height_m = (from.height_m + to.height_m) / 2;
  if (!(height_m > 0)) return speed;
  const double rise_mps = (to.height_m - from.height_m) / duration_s;
  speed.mps = std::sqrt(speed.mps * speed.mps + rise_mps * rise_mps + 2 * kGravity_mps2 * height_m);
  speed.deviation_mps += std::hypot(from.height_deviation_m, to.height_deviation_m) / duration_s;
  return speed;
}

// The speed that a ball kicked at `kicked_s` had then, by its mean speed between two sightings.
Speed kicked_speed(const RecentBall& from, const RecentBall& to, double kicked_s,
                   const Configuration& c) {
  Speed speed = mean_speed(from, to, c);
  const bool is_on_carpet = !(from.height_m + to.height_m > 0);
  if (is_on_carpet) speed.mps += kCarpet_mps2 * ((from.time_s + to.time_s) / 2 - kicked_s);
  return speed;
}

// The mean of the last three speeds, if all of them are above the limit, the mean beyond the noise.
std::optional<double> speeding_mps(const RecentFrames& recent, double kicked_s,
                                   const Configuration& c) {
  const RecentBall* newest = recent.ball(0);
  const RecentBall* oldest = recent.ball(kIntervals);
  if (oldest == nullptr || oldest->time_s < kicked_s) return std::nullopt;
  for (std::size_t back = 0; back < kIntervals; ++back) {
    const Speed speed = kicked_speed(*recent.ball(back + 1), *recent.ball(back), kicked_s, c);
    if (!(speed.mps + kBeyondNoise * speed.deviation_mps > c.rules.kick_limit_mps)) {
      return std::nullopt;
    }
  }
  const Speed mean = kicked_speed(*oldest, *newest, kicked_s, c);
  if (!(mean.mps - kBeyondNoise * mean.deviation_mps > c.rules.kick_limit_mps)) return std::nullopt;
  return mean.mps;
}

// A ball that was as fast before was made fast by somebody else; where its way before the touch is
// not known any more, it may have been. Touches are told up to a picture late: two ways count.
bool was_as_fast(const RecentFrames& recent, double kicked_s, double speed_mps,
                 const Configuration& c) {
  const RecentBall* before = recent.ball_before(kicked_s);
  for (std::size_t back = 0; recent.ball(back + 2) != nullptr; ++back) {
    if (recent.ball(back) != before) continue;
    return mean_speed(*recent.ball(back + 1), *before, c).mps >= speed_mps &&
           mean_speed(*recent.ball(back + 2), *recent.ball(back + 1), c).mps >= speed_mps;
  }
  return true;
}

// Measures the newest kick, and remembers its speed while its height is unknown.
void watch(KickSpeedWatch& kick, const BallTouch& touch, const RecentFrames& recent,
           const Moment& moment) {
  if (kick.kicked_s && *kick.kicked_s != touch.ended_s) kick = {};
  const RecentBall& newest = *recent.ball(0);
  // What seemed fast while it might have been a chip counts anew once it is one.
  if (newest.height_known && newest.height_m > 0 && !kick.is_in_air) kick = {};
  kick.is_in_air = newest.height_m > 0;
  const std::optional<double> speed_mps = speeding_mps(recent, touch.ended_s, moment.configuration);
  if (!speed_mps || was_as_fast(recent, touch.ended_s, *speed_mps, moment.configuration)) return;
  kick.kicked_s = touch.ended_s;
  kick.speed_mps = std::max(kick.speed_mps, *speed_mps);
}

}  // namespace

std::optional<Finding> find_kick_speed(Memory& memory, const Moment& moment) {
  const TouchHistory& touches = memory.play.touches;
  const BallTouch* touch = touches.newest();
  if (touch == nullptr || !touch->robot || !moment.frame.ball || !touches.recent().ball(0)) {
    return std::nullopt;
  }
  KickSpeedWatch& kick = memory.watch.kick_speed;
  watch(kick, *touch, touches.recent(), moment);
  if (!kick.kicked_s) return std::nullopt;
  const Configuration& c = moment.configuration;
  const BallSight& ball = *moment.ball;
  if (!ball.height_known && !is_out_of_field(c.field, ball.position_m)) return std::nullopt;
  Finding finding =
      offence_of(Event::kKickSpeed, RuleId::kKickSpeed, c, *touch->robot, touch->ended_m);
  finding.value = kick.speed_mps;
  finding.evidence =
      fmt::format("{} touched the ball at {:.3f} s, and it was {:.2f} m/s fast in three pictures.",
                  text_of(*touch->robot), touch->ended_s, kick.speed_mps);
  return finding;
}

}  // namespace autoref::referee
