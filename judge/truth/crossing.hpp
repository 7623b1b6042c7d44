// Where and when the true ball completely crossed a boundary of the field.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/field.hpp"

namespace autoref::judge::ground_truth {

struct Crossing {
  bool over_goal_line = false;  // otherwise over a touch line
  bool into_goal = false;       // between the posts and below the bar
  Side end = Side::kWest;       // side whose goal line or half of the touch line was crossed
  Vec2 point_m{0, 0};           // of the ball's centre
  double height_m = 0;          // of its lowest point
  double share = 0;             // of the step from the previous state, 0 to 1
};

// Distance of the ball's far edge to the field's outer lines from inside; negative once the ball is
// completely out.
double inside_m(const Field& field, const Vec2& ball_m);

// Returns nullopt unless the ball is completely out at `now` and was not at `before`. Assumes a
// straight path in between.
std::optional<Crossing> find_crossing(const Field& field, const sim::BallState& before,
                                      const sim::BallState& now);

}  // namespace autoref::judge::ground_truth
