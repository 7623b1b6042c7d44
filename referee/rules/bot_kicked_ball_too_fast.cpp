// A kick must not be faster than 8 m/s (Laws 2014, law 12), or 6.5 m/s in three dimensions (2026).
// The limit applies to the speed at the kick. On the carpet, a constant-deceleration fit to the
// ball's free path after a robot's touch is extrapolated back to the touch. The fit is evaluated
// after seven frames, when the next touch ends the path, or once the speed exceeds the limit by
// three standard deviations, but not before the fourth frame. In the air, three successive speeds
// must be above the limit (2016), and their mean must exceed it by more than the noise.
//
// Until it is known whether a kicked ball flies, its speed is also unknown: a chip seems faster
// than it is. The call waits until this is known, or until the ball is out. In the latter case, the
// ball counts as having stayed on the ground, as it does after most kicks. No foul is called if the
// kicker is unknown.
#include <fmt/format.h>
#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>

#include "referee/geometry/ball_out.hpp"
#include "referee/rules/called_touch.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/constant_acceleration_fit.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

constexpr std::size_t kIntervals = 3;
// The speed is evaluated after this many detections of the free path, whatever the uncertainty of
// the speed. It is evaluated earlier if it exceeds the limit by kSure standard deviations.
constexpr std::size_t kKickDetections = 7;
constexpr double kSure = 3;
// If the next touch ends the path early, this many detections suffice if the speed exceeds the
// limit by kSure standard deviations.
constexpr std::size_t kFewestAtEnd = 3;
// Standard deviations by which the mean speed in the air must exceed the limit.
constexpr double kBeyondNoise = 2;
// An error in an estimated height moves the position along the camera's ray, which is within 45
// degrees of the vertical, so the horizontal position changes by at most the same amount.
constexpr double kFlightDeviation = 1.4;
constexpr double kTouchTime_s = 8_ms;  // error in the time of a touch: half a frame
// Deceleration of a kicked ball, which slides at first: 3.0 to 3.9 m/s2 on the league's carpets.
constexpr double kCarpet_mps2 = 3.4;
constexpr double kCarpetDeviation_mps2 = 0.4;
constexpr double kKickRounding_m = 0.01e-3;  // position error of a noise-free camera

struct Speed {
  double mps = 0;
  double deviation_mps = 0;
};

// The mean speed between two detections. In 2026, the speed of a flying ball is converted to its
// speed at ground level by conservation of energy.
Speed mean_speed(const BallDetection& from, const BallDetection& to, const Configuration& c) {
  const double duration_s = to.time_s - from.time_s;
  // The two detections are independent: their variances add, hence the square root of 2.
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

// The ball's detections from `from_s` to `to_s`, newest first; if there are more than seven, only
// the oldest seven.
using Detections = boost::container::static_vector<const BallDetection*, FrameHistory::kRecent>;

Detections detections_of(const FrameHistory& frames, double from_s, double to_s) {
  Detections seen;
  for (std::size_t back = 0; frames.ball(back) != nullptr; ++back) {
    const BallDetection* ball = frames.ball(back);
    if (ball->time_s >= from_s && ball->time_s <= to_s) seen.push_back(ball);
  }
  while (seen.size() > kKickDetections) seen.erase(seen.begin());
  return seen;
}

// The ball's speed when it was kicked, from a fit to its path along the carpet.
Speed speed_on_carpet(const Detections& seen, double kicked_s, const Configuration& c) {
  const Vec2 direction =
      direction_of(seen.front()->position_m - seen.back()->position_m, Vec2(1, 0));
  // The fit uses the carpet's deceleration as a prior, because a few frames alone do not determine
  // it.
  ConstantAccelerationFit fit(-kCarpet_mps2 * direction, kCarpetDeviation_mps2);
  for (const BallDetection* ball : seen) {
    fit.add(ball->time_s - kicked_s, ball->position_m, std::max(c.noise.ball_m, kKickRounding_m));
  }
  const ConstantAcceleration motion = fit.motion();
  return {motion.velocity_mps.dot(direction), motion.velocity_deviation_mps};
}

// The speed of a kick whose flight the tracker estimates, once it exceeds the limit by two standard
// deviations. The vertical speed follows from the ball's height and the time since the kick. The
// positions in successive frames come from different estimates of the flight, so their differences
// are not speeds.
std::optional<double> speeding_in_flight_mps(double kicked_s, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const TrackedBall& ball = *input.tracks.ball;
  const double flown_s = input.time_s() - kicked_s;
  if (!(ball.height_m > 0) || !(flown_s > 0)) return std::nullopt;
  const bool counts_height = c.rules.edition == Edition::kRules2026;
  const double rise_mps = ball.height_m / flown_s + kGravity_mps2 * flown_s / 2;
  const double speed_mps = std::hypot(ball.velocity_mps.norm(), counts_height ? rise_mps : 0);
  const double deviation_mps = std::hypot(kFlightDeviation * ball.height_deviation_m,
                                          counts_height ? kTouchTime_s * rise_mps : 0) /
                               flown_s;
  const bool is_fast = speed_mps - kBeyondNoise * deviation_mps > c.rules.kick_limit_mps;
  return is_fast ? std::optional(speed_mps) : std::nullopt;
}

// The ball's mean speed in the air over the last three frames, if each of the three speeds may
// exceed the limit, given the noise, and their mean certainly does.
std::optional<double> speeding_in_air_mps(const FrameHistory& frames, double kicked_s,
                                          const Configuration& c) {
  const BallDetection* oldest = frames.ball(kIntervals);
  if (oldest == nullptr || oldest->time_s < kicked_s) return std::nullopt;
  for (std::size_t back = 0; back < kIntervals; ++back) {
    const Speed speed = mean_speed(*frames.ball(back + 1), *frames.ball(back), c);
    if (!(speed.mps + kBeyondNoise * speed.deviation_mps > c.rules.kick_limit_mps)) {
      return std::nullopt;
    }
  }
  const Speed mean = mean_speed(*oldest, *frames.ball(0), c);
  if (!(mean.mps - kBeyondNoise * mean.deviation_mps > c.rules.kick_limit_mps)) return std::nullopt;
  return mean.mps;
}

// If the ball was already this fast before the touch, another robot made it fast. If the ball's
// earlier path is no longer known, this cannot be ruled out. Touches may be reported a frame late,
// so the ball must have been this fast in both preceding intervals.
bool was_as_fast(const FrameHistory& frames, double kicked_s, double speed_mps,
                 const Configuration& c) {
  const BallDetection* before = frames.ball_before(kicked_s);
  for (std::size_t back = 0; frames.ball(back + 2) != nullptr; ++back) {
    if (frames.ball(back) != before) continue;
    return mean_speed(*frames.ball(back + 1), *before, c).mps >= speed_mps &&
           mean_speed(*frames.ball(back + 2), *frames.ball(back + 1), c).mps >= speed_mps;
  }
  return true;
}

// The speed of a kick, once it is certain, measured on the ball's free path until `until_s`.
// `is_over` means that no more detections will follow. Returns nullopt if the ball was already this
// fast before the touch.
std::optional<double> reported_speed_mps(const BallTouch& kick, const FrameHistory& frames,
                                         double until_s, bool is_over, const Configuration& c) {
  const Detections seen = detections_of(frames, kick.ended_s, until_s);
  const bool is_long = seen.size() > kIntervals;
  if (seen.size() < kFewestAtEnd || !(is_long || is_over)) return std::nullopt;
  const Speed speed = speed_on_carpet(seen, kick.ended_s, c);
  const bool is_sure = (is_long && is_over) || seen.size() == kKickDetections ||
                       speed.mps - c.rules.kick_limit_mps > kSure * speed.deviation_mps;
  if (!is_sure || was_as_fast(frames, kick.ended_s, speed.mps, c)) return std::nullopt;
  return speed.mps;
}

// Measures the newest kick, and stores its speed while the ball's height is unknown.
void watch(KickSpeedWatch& kick, const BallTouch& touch, const FrameHistory& frames,
           const RefereeInput& input) {
  if (kick.kicked_s && *kick.kicked_s != touch.ended_s) kick = {};
  const BallDetection& newest = *frames.ball(0);
  // If the kick turns out to be a chip, the speed measured on the carpet is discarded.
  if (newest.height_known && newest.height_m > 0 && !kick.is_in_air) {
    kick = {};
    kick.is_in_air = true;
  }
  const Configuration& c = input.configuration;
  std::optional<double> speed_mps;
  if (kick.is_in_air) {
    const bool is_estimated = input.tracks.ball && input.tracks.ball->height_deviation_m > 0;
    speed_mps = is_estimated ? speeding_in_flight_mps(touch.ended_s, input)
                             : speeding_in_air_mps(frames, touch.ended_s, c);
    if (speed_mps && was_as_fast(frames, touch.ended_s, *speed_mps, c)) speed_mps.reset();
  } else if (!kick.kicked_s) {
    speed_mps = reported_speed_mps(touch, frames, input.time_s(), false, c);
  }
  if (!speed_mps) return;
  kick.kicked_s = touch.ended_s;
  kick.speed_mps = std::max(kick.speed_mps, *speed_mps);
}

// A kick and its confirmed speed.
struct ReportedKick {
  const BallTouch* touch = nullptr;
  double speed_mps = 0;
};

// The newest kick if it is known whether the ball flies, otherwise the one before it.
ReportedKick reported_kick(KickSpeedWatch& kick, const TouchHistory& touches,
                           const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const FrameHistory& frames = input.frames;
  if (touches.has(1) && !kick.is_in_air && !(touches.at(1).highest_m > 0)) {
    const BallTouch& before = touches.at(1);
    const bool is_measured = kick.kicked_s && *kick.kicked_s == before.ended_s;
    const std::optional<double> speed_mps =
        is_measured ? std::optional(kick.speed_mps)
                    : reported_speed_mps(before, frames, touches.newest()->began_s, true, c);
    if (speed_mps && *speed_mps > c.rules.kick_limit_mps) return {&before, *speed_mps};
  }
  watch(kick, *touches.newest(), frames, input);
  const BallSight& ball = *input.ball;
  const bool is_known = ball.height_known || is_out_of_field(c.field, ball.position_m);
  if (!kick.kicked_s || !is_known) return {};
  return {touches.newest(), kick.speed_mps};
}

// Whether the ball is in the air; nullopt while that is unknown.
std::optional<bool> is_chipped(const KickSpeedWatch& watch, const ReportedKick& kick,
                               const RefereeInput& input) {
  const bool is_newest = kick.touch->ended_s == watch.kicked_s;
  if (kick.touch->highest_m > 0 || (is_newest && watch.is_in_air)) return true;
  return input.ball->height_known ? std::optional(false) : std::nullopt;
}

std::optional<Finding> find_bot_kicked_ball_too_fast(RefereeState& state,
                                                     const RefereeInput& input) {
  const TouchHistory& touches = state.play.touches;
  if (touches.newest() == nullptr || !input.frame.ball || !input.frames.ball(0)) {
    return std::nullopt;
  }
  const Configuration& c = input.configuration;
  const ReportedKick kick = reported_kick(state.watch.bot_kicked_ball_too_fast, touches, input);
  if (kick.touch == nullptr || !kick.touch->robot || !(kick.speed_mps > c.rules.kick_limit_mps)) {
    return std::nullopt;
  }
  if (is_called(state.watch.fast_kick, *kick.touch)) return std::nullopt;
  state.watch.fast_kick = called_at(*kick.touch, input.time_s());
  const RobotId kicker = *kick.touch->robot;
  Finding finding = offence_of(Event::kBotKickedBallTooFast, RuleId::kBotKickedBallTooFast, c,
                               kicker, kick.touch->ended_m);
  finding.value = kick.speed_mps;
  finding.details.is_chipped = is_chipped(state.watch.bot_kicked_ball_too_fast, kick, input);
  finding.evidence = fmt::format("{} kicked the ball at {:.3f} s with {:.2f} m/s.", text_of(kicker),
                                 kick.touch->ended_s, kick.speed_mps);
  return finding;
}

}  // namespace

constinit const Rule kBotKickedBallTooFastRule{{State::kRun}, find_bot_kicked_ball_too_fast};

}  // namespace autoref::referee
