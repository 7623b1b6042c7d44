// Where a robot may be: what the rules in force forbid right now.
#pragma once

#include "soccer/field.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {

// What a place must respect right now.
struct Limits {
  bool own_half_only = false;       // before a kick-off
  double keep_from_ball_m = 0;      // from a robot's centre to the ball
  double keep_from_area_m = 0;      // from a robot's centre to the opponents' defence area
  bool may_enter_own_area = false;  // the keeper
  // Leaves a place behind the goal line there, though too near to an area of quarter circles: as
  // `basic` does it, whose games the bench measures by.
  bool may_stay_behind_goal = false;
  double beyond_lines_m = 90_mm;  // of a robot's centre, outside the field: half of it
};

// What robots keep beyond a rule's distance where being too near counts at once (2026); else none.
double room_for_error_m(const RuleBook& rules);

// The permitted place nearest to `wanted_m`, or close to it. Where the half, an area or the field's
// edge leaves no room between itself and the ball, they are kept to, and the ball's circle is not.
Vec2 permitted(const Field& field, const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits);

// The same, but where there is no room, a place farther round the ball that keeps all limits.
Vec2 permitted_by_all(const Field& field, const Vec2& wanted_m, const Vec2& ball_m,
                      const Limits& limits);

}  // namespace autoref::strategies
