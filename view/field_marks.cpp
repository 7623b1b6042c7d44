#include "view/field_marks.hpp"

#include "league/field_message.hpp"
#include "league/message_fields.hpp"

namespace autoref::view {
namespace {

Vec2 position_of(const league::Point& point) {
  return {league::to_m(point.x()), league::to_m(point.y())};
}

}  // namespace

Outline field_lines(const Field& field) {
  league::Geometry geometry;
  league::fill_geometry(field, {}, geometry);
  Outline outline;
  for (const league::FieldLine& line : geometry.field().field_lines())
    outline.lines.push_back({position_of(line.p1()), position_of(line.p2())});
  for (const league::FieldArc& arc : geometry.field().field_arcs()) {
    outline.arcs.push_back({position_of(arc.center()), league::to_m(arc.radius()),
                            static_cast<double>(arc.a1()), static_cast<double>(arc.a2())});
  }
  return outline;
}

// Both shapes consist of the points within some distance of a core: the segment between the centres
// of the circles, or the box itself.
Outline around_defence_area(const Field& field, Side side, double distance_m) {
  const DefenceArea& area = field.defence_area;
  const bool is_box = area.shape == DefenceArea::Shape::kBox;
  const double core_m = is_box ? area.depth_m : 0;
  const double radius_m = distance_m + (is_box ? 0 : area.depth_m);
  const double half_m = area.straight_m / 2;
  const double inwards = -goal_sign(side);
  const double goal_x = field.goal_centre_m(side).x();
  const double core_x = goal_x + inwards * core_m;
  const double front_x = core_x + inwards * radius_m;
  Outline outline;
  outline.lines.push_back({{front_x, -half_m}, {front_x, half_m}});
  for (const double y : {half_m + radius_m, -half_m - radius_m})
    if (is_box) outline.lines.push_back({{goal_x, y}, {core_x, y}});
  // Each corner is a quarter of a circle, counter-clockwise from the smaller angle.
  const double north_rad = inwards > 0 ? 0 : kPi / 2;
  const double south_rad = inwards > 0 ? 1.5 * kPi : kPi;
  outline.arcs.push_back({{core_x, half_m}, radius_m, north_rad, north_rad + kPi / 2});
  outline.arcs.push_back({{core_x, -half_m}, radius_m, south_rad, south_rad + kPi / 2});
  return outline;
}

std::vector<Vec2> goal_walls_m(const Field& field, Side side) {
  const double x = field.goal_centre_m(side).x();
  const double back_x = x + goal_sign(side) * field.goal_depth_m;
  const double y = field.half_goal_m();
  if (!field.goal_sides_reach_wall)
    return {Vec2(x, y), Vec2(back_x, y), Vec2(back_x, -y), Vec2(x, -y)};
  const double wall_x = goal_sign(side) * field.wall_x_m();
  return {Vec2(x, y),       Vec2(wall_x, y),  Vec2(back_x, y),
          Vec2(back_x, -y), Vec2(wall_x, -y), Vec2(x, -y)};
}

}  // namespace autoref::view
