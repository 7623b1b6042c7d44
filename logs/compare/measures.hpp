// The measures by which games are compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace autoref::logs {

// Except for kInPlay, possessions and fouls, the measures only count what happens in running play:
// after NORMAL_START, FORCE_START and free kicks, until the next other command. Without any
// command, all play counts as running.
enum class Measure : std::uint8_t {
  kBallSpeed,
  kBallDeceleration,
  kRollLength,
  kKickSpeed,
  kRobotSpeed,
  kRobotAcceleration,
  kRobotBraking,
  kPossession,
  kInPlay,
  kStops,
  kFouls,
  kBallUnseen,
  kBallGap,
  kRobotUnseen,
};

enum class MeasureKind : std::uint8_t {
  kDistribution,  // of values
  kShare,         // of frames, from 0 to 1
  kRate,          // events per minute of running play
};

struct MeasureEntry {
  Measure measure;
  MeasureKind kind = MeasureKind::kDistribution;
  std::string_view name;
  std::string_view unit;
  double highest = 1;  // larger values of a distribution count as this one
  std::string_view about;
};

// In the order of Measure.
inline constexpr auto kMeasures = std::to_array<MeasureEntry>(
    {{Measure::kBallSpeed, MeasureKind::kDistribution, "ball_speed", "m/s", 10,
      "Speed of the ball over 0.08 s, in each frame."},
     {Measure::kBallDeceleration, MeasureKind::kDistribution, "ball_deceleration", "m/s^2", 10,
      "Deceleration of each ball that slides or rolls freely."},
     {Measure::kRollLength, MeasureKind::kDistribution, "roll_length", "m", 15,
      "How far the ball moves, if at least 0.15 m, while it is away from robots and walls."},
     {Measure::kKickSpeed, MeasureKind::kDistribution, "kick_speed", "m/s", 10,
      "Speed of each straight kick of at least 1 m/s whose ball then moves freely."},
     {Measure::kRobotSpeed, MeasureKind::kDistribution, "robot_speed", "m/s", 6,
      "Speed of the robots over 0.12 s, in each frame."},
     {Measure::kRobotAcceleration, MeasureKind::kDistribution, "robot_acceleration", "m/s^2", 10,
      "How fast robots gain speed over 0.26 s, in each frame in which they do, if they are faster "
      "than 0.4 m/s and away from other robots."},
     {Measure::kRobotBraking, MeasureKind::kDistribution, "robot_braking", "m/s^2", 10,
      "How fast such robots lose speed, in each frame in which they do."},
     {Measure::kPossession, MeasureKind::kDistribution, "possession", "s", 60,
      "Duration of each possession chain (docs/schemas.md)."},
     {Measure::kInPlay, MeasureKind::kShare, "in_play", "", 1,
      "Share of time with the ball in play, halts, timeouts and breaks left out."},
     {Measure::kStops, MeasureKind::kRate, "stops", "1/min", 1,
      "How often running play stops, per minute of running play."},
     {Measure::kFouls, MeasureKind::kRate, "fouls", "1/min", 1,
      "Fouls that AutoRef finds, per minute of running play."},
     {Measure::kBallUnseen, MeasureKind::kShare, "ball_unseen", "", 1,
      "Share of frames without a detection of the ball, hidden or not."},
     {Measure::kBallGap, MeasureKind::kDistribution, "ball_gap", "s", 5,
      "Time between two detections of the ball, if at least 0.1 s."},
     {Measure::kRobotUnseen, MeasureKind::kShare, "robot_unseen", "", 1,
      "Share of frames without a detection of a robot, in gaps of at most 0.5 s."}});
inline constexpr std::size_t kMeasureCount = kMeasures.size();

constexpr const MeasureEntry& entry_of(Measure measure) {
  return kMeasures[static_cast<std::size_t>(measure)];
}

}  // namespace autoref::logs
