// What tells who touched the ball last from stories of its ways (touch_stories.hpp).
#pragma once

#include "referee/touch/free_way.hpp"
#include "referee/touch/meetings.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {

// Costs are minus twice the logarithms of likelihoods, and squares of deviations. They were tuned
// on games of basic against basic, seeds 5001 to 5020.
struct StoryParameters {
  // What is looked at: the last seconds before the ball was out, and from before the touch that was
  // told while play was on.
  double window_s = 2.0;
  double before_told_s = 0.5;
  WayParameters way;
  MeetingParameters meeting;
  double surely = 4;      // deviations beyond which a change is not by chance
  double near_m = 30_mm;  // a robot farther from the ball's ways did not touch it
  double touch_cost = 5;  // a ball near a robot is touched in one of ten pictures
  double kick_cost = 2;
  double second_touch_cost = 1.9;  // of another robot's, or the goal's, between two pictures
  double unlikely_cost = 30;       // robots cost no more than this for the way before
  double at_hull_cost = 15;        // nor more than this in all where the ball was at their hull,
  double off_hull_cost = 50;       // and this where it was not
  double nobody_cost = 25;         // of a ball that turns with nobody near
  double jump_cost = 10;           // of a ball that jumps because it flies or lands
  double landing_cost = 4;         // of a ball in the air that loses speed
  double roll_cost = 4;            // of beginning to roll just now
  double post_off_m = 3_mm;        // standard deviation of the gap of a ball that met a goal
  double lead_cost = 1;  // a side that leads by less is not known to have touched the ball
};

}  // namespace autoref::referee
