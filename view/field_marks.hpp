// Field markings as lines and arcs, for pages and drawings.
#pragma once

#include <array>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::view {

struct MarkLine {
  Vec2 from_m{0, 0};
  Vec2 to_m{0, 0};
};

// Part of a circle, counterclockwise from `from_rad` to the larger `to_rad`.
struct MarkArc {
  Vec2 centre_m{0, 0};
  double radius_m = 0;
  double from_rad = 0;
  double to_rad = 0;
};

struct Outline {
  std::vector<MarkLine> lines;
  std::vector<MarkArc> arcs;
};

// The centre lines of the field markings, as in the league's vision geometry.
Outline field_lines(const Field& field);

// The points on the field at a distance of `distance_m` from the defence area of `side`.
Outline around_defence_area(const Field& field, Side side, double distance_m);

// The goal's inner walls: from post to post along the back and, if the goal's side walls reach the
// field's wall, to that wall and back on either side.
std::vector<Vec2> goal_walls_m(const Field& field, Side side);

}  // namespace autoref::view
