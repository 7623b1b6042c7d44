// Where a way of the ball meets the hulls of robots.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/touch/free_way.hpp"
#include "referee/touch/pictures.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

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
