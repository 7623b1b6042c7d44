#include "referee/geometry/restarts.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::referee {
namespace {

// The sign of y at the nearer touch line: 1 if the touch line at +y is nearer, otherwise -1.
double touch_line_sign(double y_m, Side kicker) {
  // The kicker's left is at +y for west, which attacks towards +x, and at -y for east.
  if (y_m == 0) return -goal_sign(kicker);
  return std::copysign(1.0, y_m);
}

Vec2 inside_lines(const Field& field, const Vec2& where_m, double inset_m) {
  const double x_m = field.half_length_m() - inset_m;
  const double y_m = field.half_width_m() - inset_m;
  return {std::clamp(where_m.x(), -x_m, x_m), std::clamp(where_m.y(), -y_m, y_m)};
}

Vec2 position_before_goal_line(const Field& field, Side kicker, const Vec2& exit_m,
                               double goal_inset_m, double touch_inset_m) {
  return {std::copysign(field.half_length_m() - goal_inset_m, exit_m.x()),
          touch_line_sign(exit_m.y(), kicker) * (field.half_width_m() - touch_inset_m)};
}

// Distance from the goal line at which a point at `y_m` is `clearance_m` from the area; 0 if it can
// be on the goal line.
double depth_at_clearance_m(const DefenceArea& area, double y_m, double clearance_m) {
  const bool round = area.shape == DefenceArea::Shape::kQuarterCircles;
  const double beyond_m = std::max(0.0, std::abs(y_m) - area.straight_m / 2);
  const double radius_m = round ? area.depth_m + clearance_m : clearance_m;
  if (beyond_m >= radius_m) return 0;
  const double depth_m = std::sqrt(radius_m * radius_m - beyond_m * beyond_m);
  return round ? depth_m : area.depth_m + depth_m;
}

// `where_m`, moved along x towards the centre until it is `clearance_m` from the area.
Vec2 moved_clear(const Field& field, Side side, const Vec2& where_m, double clearance_m) {
  const double x_m =
      field.half_length_m() - depth_at_clearance_m(field.defence_area, where_m.y(), clearance_m);
  const double end = goal_sign(side);
  return end * where_m.x() <= x_m ? where_m : Vec2(end * x_m, where_m.y());
}

// The point nearest to `where_m` that is `clearance_m` from the box of `side`, in front of or
// beside it, for rules that ask for "the closest valid position". A point on the long axis of the
// field stays on it.
Vec2 nearest_clear_of_box(const Field& field, Side side, const Vec2& where_m, double clearance_m) {
  if (distance_to_defence_area(field, side, where_m) >= clearance_m) return where_m;
  const DefenceArea& area = field.defence_area;
  if (area.shape != DefenceArea::Shape::kBox) {
    return moved_clear(field, side, where_m, clearance_m);
  }
  const double half_m = area.straight_m / 2;
  const double from_line_m = field.half_length_m() - goal_sign(side) * where_m.x();
  const Vec2 rim_m(area.depth_m, std::copysign(half_m, where_m.y()));
  const Vec2 beyond_m = Vec2(from_line_m, where_m.y()) - rim_m;
  const double beside_m = std::abs(where_m.y()) - half_m;
  // The points at a given distance from a box form a rectangle with rounded corners. This branch
  // handles a corner; the branches below handle a side and the front.
  if (beyond_m.x() > 0 && beside_m > 0) {
    const Vec2 position_m = rim_m + beyond_m.normalized() * clearance_m;
    return {goal_sign(side) * (field.half_length_m() - position_m.x()), position_m.y()};
  }
  if (beside_m > beyond_m.x() && where_m.y() != 0) {
    return {where_m.x(), std::copysign(half_m + clearance_m, where_m.y())};
  }
  return {goal_sign(side) * (field.half_length_m() - area.depth_m - clearance_m), where_m.y()};
}

}  // namespace

Vec2 throw_in_position(const Field& field, const RuleBook& rules, const Vec2& exit_m) {
  const Vec2 inside_m = inside_lines(field, exit_m, rules.throw_in_inset_m);
  return {inside_m.x(), std::copysign(field.half_width_m() - rules.throw_in_inset_m, exit_m.y())};
}

Vec2 corner_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                          const Vec2& exit_m) {
  return position_before_goal_line(field, kicker, exit_m, rules.corner_inset_m,
                                   rules.corner_inset_m);
}

Vec2 goal_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                        const Vec2& exit_m) {
  return position_before_goal_line(field, kicker, exit_m, rules.goal_kick_goal_inset_m,
                                   rules.goal_kick_touch_inset_m);
}

Vec2 free_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                        const Vec2& where_m) {
  if (rules.edition == Edition::kRules2026) {
    Vec2 position_m = inside_lines(field, where_m, rules.throw_in_inset_m);
    for (Side side : kSides) {
      position_m = nearest_clear_of_box(field, side, position_m, rules.free_kick_to_area_m);
    }
    return position_m;
  }
  if (distance_to_defence_area(field, kicker, where_m) < 0) {
    const Vec2 own_end_m(field.goal_centre_m(kicker).x(), where_m.y());
    return position_before_goal_line(field, kicker, own_end_m, rules.own_area_kick_goal_inset_m,
                                     rules.own_area_kick_touch_inset_m);
  }
  const Vec2 inside_m = inside_lines(field, where_m, rules.throw_in_inset_m);
  return moved_clear(field, opponent_of(kicker), inside_m, rules.free_kick_to_area_m);
}

Vec2 neutral_position(const Field& field, const RuleBook& rules, const Vec2& where_m) {
  Vec2 position_m = inside_lines(field, where_m, rules.throw_in_inset_m);
  for (Side side : kSides)
    position_m = moved_clear(field, side, position_m, rules.neutral_to_area_m);
  return position_m;
}

bool ball_may_stay(const Field& field, const RuleBook& rules, const Vec2& ball_m,
                   const Vec2& target_m) {
  const bool is_inside =
      std::abs(ball_m.x()) <= field.half_length_m() && std::abs(ball_m.y()) <= field.half_width_m();
  return is_inside && (ball_m - target_m).norm() < rules.placement_not_needed_m &&
         std::all_of(kSides.begin(), kSides.end(), [&](Side side) {
           return distance_to_defence_area(field, side, ball_m) >= rules.placement_to_area_m;
         });
}

bool is_out_of_reach(const Field& field, const RuleBook& rules, const Vec2& ball_m) {
  const double corner_m = rules.placement_corner_m;
  const Vec2 to_wall_m(field.wall_x_m() - std::abs(ball_m.x()),
                       field.wall_y_m() - std::abs(ball_m.y()));
  const bool is_in_corner = to_wall_m.x() < corner_m && to_wall_m.y() < corner_m;
  const double flank_m = field.half_goal_m() + field.goal_wall_thickness_m + corner_m;
  const bool is_at_goal =
      std::abs(ball_m.x()) > field.half_length_m() && std::abs(ball_m.y()) < flank_m;
  return is_in_corner || is_at_goal;
}

}  // namespace autoref::referee
