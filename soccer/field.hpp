// The field's dimensions: lines, goals, areas. The origin is at the centre, and x points towards
// the east goal.
#pragma once

#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref {

// Shape of the area in front of a goal: until 2017, two quarter circles joined by a straight line;
// since then, a box.
struct DefenceArea {
  enum class Shape { kQuarterCircles, kBox };
  Shape shape = Shape::kQuarterCircles;
  double depth_m = 0.8_m;
  double straight_m = 0.35_m;

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    visitor(self.shape, {"shape", "shape of the defence area"});
    visitor(self.depth_m,
            {"depth_m", {0.1, 5}, "radius of the quarter circles, or extent of the box along x"});
    visitor(self.straight_m, {"straight_m",
                              {0, 10},
                              "length between the quarter circles, or extent of the box along y"});
  }
};

constexpr auto names_of(DefenceArea::Shape /*any*/) {
  using Shape = DefenceArea::Shape;
  return std::to_array<Named<Shape>>(
      {{Shape::kQuarterCircles, "quarter_circles"}, {Shape::kBox, "box"}});
}

// The range of the run-off's width. It must hold a robot, because a robot that takes a free kick
// from a line, or comes back after a card, stands beyond the line.
inline constexpr Range kRunOffRange = {2 * kRobotRadius_m, 5};

// The field's dimensions. All lengths are measured to the outer edges of the lines. The defaults
// are the paper's field (section 3) and the single-size field of the Laws of 2014.
struct Field {
  double length_m = 6.05_m;
  double width_m = 4.05_m;
  double run_off_m = 0.675_m;
  double goal_line_run_off_m = 0;
  double goal_substitution_area_m = 0;  // 2026, division A
  double line_width_m = 10_mm;
  double centre_circle_radius_m = 500_mm;
  double penalty_mark_m = 750_mm;
  DefenceArea defence_area;
  double goal_width_m = 700_mm;
  double goal_depth_m = 180_mm;
  double goal_opening_height_m = 155_mm;  // the paper's G_h
  double goal_bar_radius_m = 5_mm;        // a round bar of at most 10 mm (Laws 2014, law 1)
  double goal_wall_thickness_m = 20_mm;
  bool goal_sides_reach_wall = false;  // true in 2026

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
    // Smaller fields are too small for 16 robots per side; larger fields exceed the range of sizes
    // that Box2D supports.
    visitor(self.length_m,
            {"length_m", {4, 30}, "distance between the outer edges of the goal lines"});
    visitor(self.width_m,
            {"width_m", {2, 20}, "distance between the outer edges of the touch lines"});
    visitor(self.run_off_m,
            {"run_off_m", kRunOffRange, "distance from the touch lines to the wall"});
    visitor(self.goal_line_run_off_m, {"goal_line_run_off_m",
                                       {0, kRunOffRange.high},
                                       "distance from the goal lines to the wall; 0: run_off_m"});
    visitor(self.goal_substitution_area_m,
            {"goal_substitution_area_m",
             {0, 5},
             "width of the areas behind the goal lines in which robots may be exchanged; 0: none; "
             "only sent in vision packets, nothing else depends on it"});
    visitor(self.line_width_m, {"line_width_m", {0, 0.05}, "width of the lines"});
    visitor(self.centre_circle_radius_m,
            {"centre_circle_radius_m", {0.1, 5}, "radius to the outer edge of the line"});
    visitor(self.penalty_mark_m,
            {"penalty_mark_m", positive(20), "distance from the goal line of the attacked goal"});
    visitor(self.defence_area, {"defence_area", "the area in front of a goal"});
    visitor(self.goal_width_m, {"goal_width_m", {0.2, 5}, "distance between the posts"});
    visitor(self.goal_depth_m,
            {"goal_depth_m", {0.05, 1}, "distance from the goal line to the back wall"});
    visitor(self.goal_opening_height_m,
            {"goal_opening_height_m", positive(2), "clear height under the bar"});
    visitor(self.goal_bar_radius_m,
            {"goal_bar_radius_m", {0.001, 0.05}, "radius of the goal's round bar"});
    visitor(self.goal_wall_thickness_m,
            {"goal_wall_thickness_m", {0.01, 0.1}, "thickness of the goal walls"});
    visitor(self.goal_sides_reach_wall,
            {"goal_sides_reach_wall",
             "the goals' side walls extend to the wall, so nothing passes behind a goal"});
  }

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

// Distance in metres from `point_m` to the boundary of the defence area of `side`; negative if the
// point is inside. The area is treated as if it continued behind the goal line.
double distance_to_defence_area(const Field& field, Side side, const Vec2& point_m);

// Whether the point lies within the outer edges of the lines.
bool is_on_field(const Field& field, const Vec2& point_m);

// The point, moved inside the walls if a robot could not be centred there.
Vec2 inside_walls(const Field& field, const Vec2& point_m);

}  // namespace autoref
