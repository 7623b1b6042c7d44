// From single pictures to motion: positions with velocities, held through short gaps.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <optional>

#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref {

struct TrackedRobot {
  int number = 0;
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
  Vec2 velocity_mps{0, 0};
  double angular_velocity_radps = 0;
};

struct TrackedBall {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  double height_m = 0;  // of the lowest point; 0 where vision does not report it
};

using TrackedRobots = boost::container::static_vector<TrackedRobot, kMaxRobots>;

// The field as last known, in the frame of the pictures it came from.
struct Tracks {
  double time_s = 0;
  PerSide<TrackedRobots> robots;    // ordered by number
  std::optional<TrackedBall> ball;  // none before the ball was first seen
};

// Turns a sequence of frames into tracks. One tracker per consumer, fed with frames in
// order; a frame fed again changes nothing. Velocities are differences between the last two
// sightings. What is not seen keeps its last place: a robot for 0.5 s, after which it counts as
// gone, the ball without limit.
class Tracker {
 public:
  static constexpr double kForgetRobotAfter_s = 500_ms;

  const Tracks& update(const Frame& frame);
  const Tracks& tracks() const { return tracks_; }

 private:
  struct Memory {
    TrackedRobot robot;
    double seen_s = -1;  // time of the last sighting; negative: never
  };

  void see(Memory& memory, const RobotObservation& seen, double time_s) const;
  void see_ball(const BallObservation& seen, double time_s);

  PerSide<std::array<Memory, kMaxRobots>> memory_;
  double ball_seen_s_ = 0;
  Tracks tracks_;
};

// The tracks seen from the other end: turned by 180 degrees, the sides swapped.
TrackedRobot mirrored(const TrackedRobot& robot);
TrackedBall mirrored(const TrackedBall& ball);

}  // namespace autoref
