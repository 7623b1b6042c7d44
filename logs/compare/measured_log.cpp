#include "logs/compare/measured_log.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "logs/fit/free_stretches.hpp"
#include "logs/fit/kicks.hpp"
#include "logs/fit/window_motion.hpp"
#include "referee/event.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kBallHalf_s = 40_ms;   // half of the time over which the ball's speed is measured
constexpr double kCommandWithin_s = 1;  // of the start of a log
constexpr double kShortestGap_s = 100_ms;
// A longer time without a frame is a gap in the recording.
constexpr double kRecordingGap_s = 100_ms;

bool is_break(Stage stage) {
  switch (stage) {
    case Stage::kFirstHalf:
    case Stage::kSecondHalf:
    case Stage::kExtraFirstHalf:
    case Stage::kExtraSecondHalf:
      return false;
    default:
      return true;
  }
}

bool is_interrupted(const RefereeSignal& signal) {
  const CommandKind kind = signal.command.kind;
  return kind == CommandKind::kHalt || kind == CommandKind::kTimeout || is_break(signal.stage);
}

// The ball's speed around a frame. Returns nullopt if one camera does not see it before and after.
std::optional<double> ball_speed_mps(const RecordedMotion& motion, std::size_t frame,
                                     std::size_t half) {
  if (frame < half || frame + half >= motion.frames()) return std::nullopt;
  const BallSight& before = motion.ball[frame - half];
  const BallSight& after = motion.ball[frame + half];
  const double span_s = after.time_s - before.time_s;
  const double full_s = static_cast<double>(2 * half) * motion.interval_s;
  if (!before.is_seen || !after.is_seen || before.camera != after.camera || span_s <= 0 ||
      span_s > full_s + 1.5 * motion.interval_s)
    return std::nullopt;
  return (after.position_m - before.position_m).norm() / span_s;
}

// The decelerations in the stretch that are determined well.
std::vector<double> decelerations_mps2(const FreeStretch& stretch) {
  std::vector<double> clear;
  const auto add = [&](const Measured& deceleration_mps2) {
    if (deceleration_mps2.deviation < FreeStretch::kVagueSliding_mps2)
      clear.push_back(std::max(deceleration_mps2.value, 0.0));
  };
  if (stretch.has_one_phase()) {
    add(stretch.one.deceleration_mps2);
  } else if (stretch.has_two_phases()) {
    add(stretch.two->first_mps2);
    add(stretch.two->second_mps2);
  }
  return clear;
}

}  // namespace

void GamesMeasurer::note(const LogReferee& judged) {
  const referee::AutoRef& referee = judged.referee();
  const double time_s = referee.frame().time_s;
  if (!is_interrupted(judged.signal()))
    add(Measure::kInPlay, time_s, referee.is_ball_in_play() ? 1 : 0);
  for (const referee::Decision& decision : referee.decisions())
    if (referee::entry_of(decision.finding.event).is_foul) add(Measure::kFouls, time_s, 1);
}

void GamesMeasurer::finish_log(const std::string& path, const PlayOfLog& play) {
  for (const game::PossessionChain& chain : play.chains) {
    const auto at_s = [](std::int64_t frame) {
      return static_cast<double>(frame) / RecordedPlay::kRate_hz;
    };
    add(Measure::kPossession, at_s(chain.first_frame),
        at_s(chain.last_frame) - at_s(chain.first_frame));
  }
  has_stops_ = false;
  for_each_motion(path, [&](const RecordedMotion& motion) { add(motion); });
  if (!has_stops_) {
    for (const Measure measure : {Measure::kStops, Measure::kInPlay})
      games_.discard(games_.logs(), measure);
  }
  paths_[games_.logs()] = path;
}

void GamesMeasurer::add(const RecordedMotion& motion) {
  ball_.add(motion);
  add_ball_speeds(motion);
  add_ball_paths(motion);
  add_robots(motion);
  add_play(motion);
  add_ball_sights(motion);
}

void GamesMeasurer::add_ball_speeds(const RecordedMotion& motion) {
  const std::size_t half = frames_in(kBallHalf_s, motion, 1);
  for (std::size_t frame = 0; frame < motion.frames(); ++frame) {
    if (!motion.is_running[frame]) continue;
    if (const auto speed_mps = ball_speed_mps(motion, frame, half))
      add(Measure::kBallSpeed, motion.times_s[frame], *speed_mps);
  }
}

void GamesMeasurer::add_ball_paths(const RecordedMotion& motion) {
  for (const FreeStretch& stretch : free_stretches_in(motion)) {
    for (const double deceleration_mps2 : decelerations_mps2(stretch))
      add(Measure::kBallDeceleration, motion.times_s[stretch.frames.front()], deceleration_mps2);
  }
  for (const std::vector<std::size_t>& path : free_paths_in(motion)) {
    const Vec2 moved_m = motion.ball[path.back()].position_m - motion.ball[path.front()].position_m;
    if (moved_m.norm() >= kShortestPath_m)
      add(Measure::kRollLength, motion.times_s[path.front()], moved_m.norm());
  }
}

void GamesMeasurer::add_robots(const RecordedMotion& motion) {
  for (std::size_t robot = 0; robot < motion.robots.size(); ++robot) {
    for (std::size_t frame = 0; frame < motion.frames(); ++frame) {
      if (!motion.is_running[frame]) continue;
      const double time_s = motion.times_s[frame];
      const RobotSight& sight = motion.robots[robot].sights[frame];
      if (sight.is_known) add(Measure::kRobotUnseen, time_s, sight.is_seen ? 0 : 1);
      if (const auto now = window_motion(motion, robot, frame, kSpeedHalf_s))
        add(Measure::kRobotSpeed, time_s, now->speed_mps.value);
      if (const auto gain_mps2 = speed_gain_mps2(motion, robot, frame))
        add(gain_mps2->value > 0 ? Measure::kRobotAcceleration : Measure::kRobotBraking, time_s,
            std::abs(gain_mps2->value));
    }
  }
}

void GamesMeasurer::add_play(const RecordedMotion& motion) {
  for (std::size_t frame = 0; frame < motion.frames(); ++frame) {
    const double time_s = motion.times_s[frame];
    // Play counts as running before the first command, so a stop right at the start does not count.
    if (frame > 0 && motion.is_running[frame - 1] && !motion.is_running[frame] &&
        time_s - motion.times_s.front() > kCommandWithin_s) {
      has_stops_ = true;
      add(Measure::kStops, time_s, 1);
    }
    if (!motion.is_running[frame]) continue;
    running_s_ += motion.interval_s;
    for (const Measure measure : {Measure::kStops, Measure::kFouls})
      games_.add_time(games_.logs(), measure, time_s, motion.interval_s);
  }
}

void GamesMeasurer::add_ball_sights(const RecordedMotion& motion) {
  std::optional<std::size_t> last;  // frame of the last detection in running play
  for (std::size_t frame = 0; frame < motion.frames(); ++frame) {
    const double time_s = motion.times_s[frame];
    const bool is_cut = frame > 0 && time_s - motion.times_s[frame - 1] > kRecordingGap_s;
    if (!motion.is_running[frame] || is_cut) last.reset();
    if (!motion.is_running[frame]) continue;
    const BallSight& sight = motion.ball[frame];
    add(Measure::kBallUnseen, time_s, sight.is_seen ? 0 : 1);
    if (!sight.is_seen) continue;
    const double gap_s = last ? sight.time_s - motion.ball[*last].time_s : 0;
    if (gap_s >= kShortestGap_s) add(Measure::kBallGap, motion.times_s[*last], gap_s);
    last = frame;
  }
}

const MeasuredGames& GamesMeasurer::finish() {
  const sim::BallParameters ball = ball_.ball();
  for (const auto& [log, path] : paths_) {
    const int number = log;
    for_each_motion(path, [&](const RecordedMotion& motion) {
      for (const Kick& kick : kicks_in(motion, ball)) {
        if (kick.is_clear()) games_.add(number, Measure::kKickSpeed, kick.time_s, kick.speed_mps);
      }
    });
  }
  return games_;
}

}  // namespace autoref::logs
