// Where and when the true ball crossed a boundary of the field, wholly.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::runner::ground_truth {

struct Crossing {
  bool over_goal_line = false;  // else over a touch line
  bool into_goal = false;       // between the posts and below the bar
  Side end = Side::kWest;       // whose goal line, or whose half of the touch line
  Vec2 point_m{0, 0};           // of the ball's centre
  double height_m = 0;          // of its lowest point
  double share = 0;             // of the way from the state before, 0 to 1
};

// How far the ball's far edge is inside the field's outer lines; negative once it is wholly out.
double inside_m(const Field& field, const Vec2& ball_m);

// None unless the ball is wholly out at `now` and was not at `before`. The way between is taken to
// be straight.
std::optional<Crossing> find_crossing(const Field& field, const sim::BallState& before,
                                      const sim::BallState& now);

}  // namespace autoref::runner::ground_truth
