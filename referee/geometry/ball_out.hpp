// Where the ball leaves the field: the calculations of the paper's section 4.4, "Ball Position".
#pragma once

#include <cstdint>
#include <optional>

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::referee {

// Whether a ball centred at `ball_m` is out of the field: |b_x| > b_r + F_x or |b_y| > b_r + F_y.
// Deviation D7: the paper prints the test without absolute values.
bool is_out_of_field(const Field& field, const Vec2& ball_m);

enum class ExitLine : std::uint8_t { kTouch, kGoal };

struct Exit {
  ExitLine line = ExitLine::kTouch;
  Vec2 point_m{0, 0};  // position of the ball's centre as it crosses the boundary, which is
                       // expanded by the ball's radius
};

// Which boundary the ball crossed between `before_m` and `ball_m`, and where. The ball must be out
// of the field at `ball_m`. A path exactly through the expanded corner crosses the goal line, as in
// the paper, where only |c_x| < |l_x| means a touch line. If the ball was already out at
// `before_m`, it is taken to have crossed the boundary that it is farther beyond, at its current
// position along that boundary.
Exit find_exit(const Field& field, const Vec2& before_m, const Vec2& ball_m);

// The `across` coordinate at which the line through (along0, across0) and (along1, across1) meets
// `along = at`. This is the paper's formula for c_y (and, with x and y exchanged, c_x). Returns
// nullopt if the line is parallel to the boundary.
std::optional<double> intersection(double along0, double across0, double along1, double across1,
                                   double at);

// Whether the ball is in a goal: |b_x| > F_x + b_r, |b_y| < G_w and b_z < G_h, where b_z is the
// height of the ball's centre. `height_m` is the height of the ball's lowest point.
bool is_in_goal(const Field& field, const Vec2& ball_m, double height_m);

}  // namespace autoref::referee
