// Distances of a robot's hull, computed from sampled points of its outline; the ball's crossings of
// the lines; and whether only a keeper may hold the ball.
#pragma once

#include <optional>

#include "judge/truth/true_frame.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::judge::ground_truth {

// Minimum and maximum over all points of the outline.
struct Reach {
  double nearest_m = 0;
  double farthest_m = 0;
};

// Distances from the robot's outline to the defence area of `side`, negative inside; exact to 0.05
// mm.
Reach reach_to_area(const Field& field, Side side, const sim::RobotState& robot);

// Distances of the robot's outline from the halfway line into the half of `side`, negative in the
// other half.
Reach reach_into_half(Side side, const sim::RobotState& robot);

// Distance from a robot's hull to the ball's centre, which the rules call the distance to the ball.
double hull_to_ball_m(const sim::RobotState& robot, const sim::BallState& ball);

// Returns whether two robots are in contact, treated as discs, as in the simulated physics. During
// a lasting contact, they may be slightly apart in some frames.
bool are_in_contact(const sim::RobotState& a, const sim::RobotState& b);

// Where and when the true ball crossed a boundary of the field completely.
struct Crossing {
  bool over_goal_line = false;  // otherwise over a touch line
  bool into_goal = false;       // between the posts and below the bar
  Side end = Side::kWest;       // the side that defends the crossed goal line or half of touch line
  Vec2 point_m{0, 0};           // position of the ball's centre
  double height_m = 0;          // height of the ball's lowest point
  // Time of the crossing as a fraction of the step from the previous state, 0 to 1.
  double share = 0;
};

// Distance from the field's outer lines to the ball's farthest edge inside them; negative once the
// ball is completely out.
double inside_m(const Field& field, const Vec2& ball_m);

// Returns nullopt unless the ball is completely out at `now` and was not at `before`. Assumes a
// straight path in between.
std::optional<Crossing> find_crossing(const Field& field, const sim::BallState& before,
                                      const sim::BallState& now);

// Whether only the keeper of `side` may hold the ball. Laws 2014: the ball is inside the keeper's
// defence area and in contact with the keeper. 2026: the ball is inside the area, for whatever
// reason.
bool is_keepers_ball(const TrueFrame& frame, Side side);

}  // namespace autoref::judge::ground_truth
