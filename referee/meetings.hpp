// Where a way of the ball meets the hulls of robots.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/free_way.hpp"
#include "soccer/frame.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// What is kept of a picture.
struct Picture {
  struct Robot {
    RobotId id;
    Vec2 position_m{0, 0};
    Vec2 heading{1, 0};
  };
  double time_s = 0;
  bool has_ball = false;
  Vec2 ball_m{0, 0};    // where it was last seen, without one
  double height_m = 0;  // of the lowest point
  boost::container::static_vector<Robot, 2 * kMaxRobots> robots;  // within a metre of the ball
};

// The last pictures, by number; numbers count from 0.
class Pictures {
 public:
  static constexpr int kKept = 128;

  void clear() { newest_ = -1; }
  void push(const Frame& frame, const Vec2& ball_m);
  std::int64_t newest() const { return newest_; }
  const Picture& operator[](std::int64_t number) const {
    return kept_[static_cast<std::size_t>(number % kKept)];
  }

 private:
  std::array<Picture, kKept> kept_;
  std::int64_t newest_ = -1;
};

// Costs are squares of deviations, as of minus twice the logarithm of a likelihood.
struct MeetingParameters {
  double contact_m = 1_mm;  // standard deviation of the gap between bodies that touch
  double slack_m = 1_mm;    // physics leaves half a millimetre, and lets bodies overlap by 1.5
  double reach_m = 15_mm;   // of kickers, beyond the plate
  double kick_rad = 0.08;   // standard deviation of a kick's direction from the robot's heading
  double robot_m = 0;       // and of robots' sightings; the detector sets them to the noise
  double robot_rad = 0;     // it is told of
};

inline constexpr double kNever = 1e9;

// A way and a robot.
struct Meeting {
  RobotId robot;
  double bounce_cost = kNever;  // of a touch by the hull
  double kick_cost = kNever;    // of a kick
  double least_gap_m = 1;       // from the ball's surface to the hull
  double time_s = 0;            // of the likeliest touch, and the gap then
  double gap_m = 0;
};
using Meetings = boost::container::static_vector<Meeting, 2 * kMaxRobots>;

struct Walk {
  Meetings met;
  double through_cost = 0;  // of the hulls that the whole way would have gone through
};

// Follows a way from the picture `from`, where it starts, to the picture `to` before or after it. A
// touch costs what the ball is off the hull at that time, and what hulls it went through until
// then. A walk backwards asks who may have sent the ball on this way, and so weighs for kicks the
// robot's heading against the way's.
Walk walk(const FreeWay& way, const Pictures& pictures, std::int64_t from, std::int64_t to,
          const MeetingParameters& parameters);

}  // namespace autoref::referee
