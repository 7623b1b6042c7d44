// Where a way of the ball meets the hulls of robots.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/touch/ball_motion_filter.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// Costs are squares of deviations, as of minus twice the logarithm of a likelihood.
struct HullIntersectionParameters {
  double contact_m = 1_mm;  // standard deviation of the gap between bodies that touch
  double slack_m = 1_mm;    // physics leaves half a millimetre, and lets bodies overlap by 1.5
  double reach_m = 15_mm;   // of kickers, beyond the plate
  double kick_rad = 0.08;   // standard deviation of a kick's direction from the robot's heading
  double robot_m = 0;       // and of robots' detections; the detector sets them to the noise
  double robot_rad = 0;     // it is told of
};

inline constexpr double kNever = 1e9;

// A way and a robot.
struct HullIntersection {
  RobotId robot;
  double bounce_nll = kNever;  // of a touch by the hull
  double kick_nll = kNever;    // of a kick
  double least_gap_m = 1;      // from the ball's surface to the hull
  double time_s = 0;           // of the likeliest touch, and the gap then
  double gap_m = 0;
};
using HullIntersections = boost::container::static_vector<HullIntersection, 2 * kMaxRobots>;

struct Walk {
  HullIntersections intersections;
  double through_nll = 0;  // of the hulls that the whole way would have gone through
};

// Follows a way from the frame `from`, where it starts, to the frame `to` before or after it. A
// touch costs what the ball is off the hull at that time, and what hulls it went through until
// then. A walk backwards asks who may have sent the ball on this way, and so weighs for kicks the
// robot's heading against the way's.
Walk walk(const BallMotionFilter& motion, const FrameHistory& frame_history, std::int64_t from,
          std::int64_t to, const HullIntersectionParameters& parameters);

}  // namespace autoref::referee
