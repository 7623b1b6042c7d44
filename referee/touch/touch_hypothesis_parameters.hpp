// What tells who touched the ball last from hypotheses of its ways
// (retrospective_touch_detector.hpp).
#pragma once

#include "referee/touch/ball_motion_filter.hpp"
#include "referee/touch/hull_intersections.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// Costs are minus twice the logarithms of likelihoods, and squares of deviations. They were tuned
// on games of basic against basic, seeds 5001 to 5020.
struct TouchHypothesisParameters {
  // What is looked at: the last seconds before the ball was out, and from before the touch that was
  // told while play was on.
  double window_s = 2.0;
  double before_reported_s = 0.5;
  BallMotionParameters motion;
  HullIntersectionParameters intersection;
  double surely = 4;      // deviations beyond which a change is not by chance
  double near_m = 30_mm;  // a robot farther from the ball's ways did not touch it
  double touch_nll = 5;   // a ball near a robot is touched in one of ten frames
  double kick_nll = 2;
  double second_touch_nll = 1.9;  // of another robot's, or the goal's, between two frames
  double unlikely_nll = 30;       // robots cost no more than this for the way before
  double at_hull_nll = 15;        // nor more than this in all where the ball was at their hull,
  double off_hull_nll = 50;       // and this where it was not
  double nobody_nll = 25;         // of a ball that turns with nobody near
  double jump_nll = 10;           // of a ball that jumps because it flies or lands
  double landing_nll = 4;         // of a ball in the air that loses speed
  double roll_nll = 4;            // of beginning to roll just now
  double post_off_m = 3_mm;       // standard deviation of the gap of a ball that met a goal
  double lead_nll = 1;            // a side that leads by less is not known to have touched the ball
};

}  // namespace autoref::referee
