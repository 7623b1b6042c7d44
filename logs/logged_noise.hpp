// Measures the noise of the vision that recorded a log.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "soccer/frame.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {

// Differences of the third order of four successive positions: nearly free of motion, since
// accelerations change slowly compared with frames, and sqrt(20) times as noisy as a position. The
// median absolute value ignores kicks and false detections.
class LoggedNoise {
 public:
  // Frames must be in order of time.
  void take(const Frame& frame);

  // Standard deviations. Zero where there is hardly any noise, as in the logs of a simulator
  // without it. nullopt if the log is too short or its frames are too irregular to tell.
  std::optional<tracking::VisionNoise> noise() const;

 private:
  // The latest positions of one body.
  class Track {
   public:
    // Returns the third difference if there have been four evenly spaced positions.
    std::optional<Vec2> take(double time_s, const Vec2& position);

   private:
    struct Position {
      double time_s = 0;
      Vec2 at{0, 0};
    };
    std::vector<Position> latest_;
  };

  void take(const RobotObservation& robot, Side side, double time_s);

  PerSide<std::array<Track, kMaxRobots>> robots_;
  PerSide<std::array<Track, kMaxRobots>> headings_;
  Track ball_;
  std::vector<double> robot_m_;
  std::vector<double> robot_rad_;
  std::vector<double> ball_m_;
};

}  // namespace autoref::logs
