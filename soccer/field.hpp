// The field's dimensions: lines, goals, areas. Origin at the centre, x towards the east goal.
#pragma once

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref {

// Shape of the area in front of a goal: until 2017 two quarter circles joined by a straight line,
// since then a box.
struct DefenceArea {
  enum class Shape { kQuarterCircles, kBox };
  Shape shape = Shape::kQuarterCircles;
  double depth_m = 0.8_m;      // radius of the quarter circles, or the box's size along x
  double straight_m = 0.35_m;  // line between the quarter circles, or the box's size along y
};

// All lengths are measured to the outer edges of the lines. Defaults: the paper's field, section 3,
// and Laws 2014 single size.
struct Field {
  double length_m = 6.05_m;
  double width_m = 4.05_m;
  double run_off_m = 0.675_m;      // from the outer edge of the touch lines to the wall
  double goal_line_run_off_m = 0;  // from that of the goal lines; 0: as far as from touch lines
  double goal_substitution_area_m = 0;  // width of the areas behind the goal lines in which robots
                                        // may be exchanged (2026, division A); 0: without
  double line_width_m = 10_mm;
  double centre_circle_radius_m = 500_mm;
  double penalty_mark_m = 750_mm;  // from the goal line of the goal attacked
  DefenceArea defence_area;
  double goal_width_m = 700_mm;
  double goal_depth_m = 180_mm;
  double goal_opening_height_m = 155_mm;  // to the underside of the bar: the paper's G_h
  double goal_bar_radius_m = 5_mm;        // a round bar of at most 10 mm (Laws 2014, law 1)
  double goal_wall_thickness_m = 20_mm;
  bool goal_sides_reach_wall = false;  // the goals' side walls go on to the wall (2026)

  double half_length_m() const { return length_m / 2; }    // the paper's F_x
  double half_width_m() const { return width_m / 2; }      // the paper's F_y
  double half_goal_m() const { return goal_width_m / 2; }  // the paper's G_w
  double behind_goal_lines_m() const {
    return goal_line_run_off_m > 0 ? goal_line_run_off_m : run_off_m;
  }
  double wall_x_m() const { return half_length_m() + behind_goal_lines_m(); }
  double wall_y_m() const { return half_width_m() + run_off_m; }
  Vec2 goal_centre_m(Side side) const { return {goal_sign(side) * half_length_m(), 0.0}; }
  // The penalty mark in front of the goal of `side`.
  Vec2 penalty_mark_at(Side side) const {
    return {goal_sign(side) * (half_length_m() - penalty_mark_m), 0.0};
  }
};

// Distance in metres from `point_m` to the boundary of the defence area of `side`; negative inside.
// The area is treated as if it continued behind the goal line.
double distance_to_defence_area(const Field& field, Side side, const Vec2& point_m);

// Whether the point lies within the outer edges of the lines.
bool is_on_field(const Field& field, const Vec2& point_m);

}  // namespace autoref
