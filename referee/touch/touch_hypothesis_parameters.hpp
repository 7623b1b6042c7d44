// Parameters of the retrospective touch detector (retrospective_touch_detector.hpp).
#pragma once

#include "referee/touch/ball_motion_filter.hpp"
#include "referee/touch/hull_intersections.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// Deviances are minus twice log-likelihoods. They are priors of events, or upper limits that make
// the likelihoods robust against outliers. The values were tuned on games between two `basic`
// teams, seeds 5001 to 5020.
struct TouchHypothesisParameters {
  // The window starts `window_s` before the ball left the field, or `before_reported_s` before the
  // online detector's last touch, whichever is earlier.
  double window_s = 2.0;
  double before_reported_s = 0.5;
  BallMotionParameters motion;
  HullIntersectionParameters intersection;
  double surely = 4;          // gate for the innovation, in standard deviations
  double near_m = 30_mm;      // a robot farther from the ball's path did not touch it
  double touch_deviance = 5;  // a touch near a robot happens in one frame in ten: -2 log 0.1
  double kick_deviance = 2;
  double second_touch_deviance = 1.9;  // another touch by a robot or goal between two frames
  double unlikely_deviance = 30;       // upper limit for the path before a robot's touch
  double at_hull_deviance = 15;        // upper limit for a whole touch if the ball was at the hull
  double off_hull_deviance = 50;  // upper limit for a whole touch if the ball was not at the hull
  double nobody_deviance = 25;    // a velocity change with no robot nearby
  double jump_deviance = 10;      // a jump of a ball that takes off or lands
  double landing_deviance = 4;    // a flying ball that loses speed
  double roll_deviance = 4;       // the ball begins to roll in this frame
  double post_off_m = 3_mm;       // standard deviation of the gap at a bounce off a goal
  // If the deviances of the two sides differ by less, the nearer robot touched the ball last.
  double lead_deviance = 1.5;
};

}  // namespace autoref::referee
