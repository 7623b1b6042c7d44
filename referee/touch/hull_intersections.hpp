// Intersections of the ball's path with the hulls of robots.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "referee/touch/ball_motion_filter.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// Deviances are normalised squared distances: minus twice the log-likelihood of a Gaussian.
struct HullIntersectionParameters {
  double contact_m = 1_mm;  // standard deviation of the gap between bodies that touch
  double slack_m = 1_mm;    // physics leaves gaps of 0.5 mm and overlaps of 1.5 mm
  double reach_m = 15_mm;   // reach of the kicker beyond the plate
  double kick_rad = 0.08;   // standard deviation of a kick's direction from the robot's heading
  double robot_m = 0;       // vision noise of robot poses, set by the detector
  double robot_rad = 0;
};

inline constexpr double kNever = 1e9;  // deviance of an impossible event

// The intersection of a path with one robot's hull.
struct HullIntersection {
  RobotId robot;
  double bounce_deviance = kNever;  // deviance of a touch by the hull
  double kick_deviance = kNever;    // deviance of a kick
  double least_gap_m = 1;           // smallest gap from the ball's surface to the hull
  double time_s = 0;                // time of the likeliest touch
  double gap_m = 0;                 // gap at that time
};
using HullIntersections = boost::container::static_vector<HullIntersection, 2 * kMaxRobots>;

struct Walk {
  HullIntersections intersections;
  double through_deviance = 0;  // deviance of passing through hulls, along the whole path
};

// Samples the path that starts at frame `from` up to frame `to`, which may be earlier. A touch's
// deviance is that of the gap between ball and hull at that time, plus the deviance of the hulls
// that the ball has passed through until then. If `to` is earlier, the path began with a touch, so
// the deviance of a kick also depends on the angle between the robot's heading and the path.
Walk walk(const BallMotionFilter& motion, const FrameHistory& frame_history, std::int64_t from,
          std::int64_t to, const HullIntersectionParameters& parameters);

}  // namespace autoref::referee
