// Paths of balls that left the field, taken from one log to be replayed in another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "tests/logs/refereed_log.hpp"

namespace autoref::logs {

enum class ExitLine : std::uint8_t { kTouchLine, kGoalLine, kGoal };

// The straight path of a kicked ball over a line as the cameras saw it, noise and missed detections
// included.
struct BallExit {
  struct Detection {
    double time_s = 0;    // since the first detection
    double along_m = 0;   // along the path, from the line: negative on the field
    double across_m = 0;  // to the left of the path
  };

  ExitLine line = ExitLine::kTouchLine;
  double steepness = 1;               // cosine of the angle between the path and the line's normal
  std::vector<Detection> detections;  // until 0.2 s after the ball crossed the line

  double length_m() const { return -detections.front().along_m; }
  double duration_s() const { return detections.back().time_s; }
  // Time at which the ball first was this far along the path; the end of the path if it never was.
  double time_at_s(double along_m) const;
  // The position, interpolated between detections; nullopt where the cameras missed the ball.
  std::optional<BallExit::Detection> at(double time_s) const;
};

// All exits in a log that AutoRef called 0.4 to 0.9 s after an unambiguous last touch.
std::vector<BallExit> exits_in(const RefereedLog& log);

// The point at which a path first leaves the field.
struct Crossing {
  ExitLine line = ExitLine::kTouchLine;
  double distance_m = 0;  // of the ball's centre to the line, along the path
  double steepness = 1;
  Vec2 position_m{0, 0};
};

// The crossing of a straight path that starts on the field.
Crossing crossing_of(const Field& field, const Vec2& from_m, const Vec2& direction);

}  // namespace autoref::logs
