// Where the rules currently allow a robot to be, and how it avoids contact with opponents.
#pragma once

#include "soccer/field.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/tracks.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {

// How gently a robot approaches opponents. The defaults nearly rule out crashes.
struct Easing {
  double from_m = 1.2;         // gap between hulls below which the closing speed is limited
  double gentle_mps = 0.2;     // closing speed allowed at contact
  double braking_mps2 = 1.2;   // braking that determines the speed allowed at a distance
  double contact_mps = 100.0;  // largest speed towards an opponent in contact; no robot is that
                               // fast
};

// Limits the closing speed of `robot` towards each nearby opponent to a braking curve over the gap.
// Only the component towards the opponent is reduced, so the robot can still slide past it.
void ease_off(const TrackedRobot& robot, const TrackedRobots& opponents, const Easing& easing,
              RobotCommand& command);

// The limits that a position must respect.
struct Limits {
  bool own_half_only = false;       // before a kick-off
  double keep_from_ball_m = 0;      // from a robot's centre to the ball
  double keep_from_area_m = 0;      // from a robot's centre to the opponents' defence area
  bool may_enter_own_area = false;  // true for the keeper
  // Keeps a position that is behind the goal line, even if it is too near to a quarter-circle area.
  // `basic` relies on this, and the benchmark's games depend on it.
  bool may_stay_behind_goal = false;
  double beyond_lines_m = 90_mm;  // how far a robot's centre may be outside the field
};

// The largest |x| and |y| that a robot's centre can have if there are walls near the lines;
// infinite if the run-off is wide enough to keep the distance that the rules require from a ball on
// a line.
Vec2 farthest_between_walls_m(const Field& field);

// The direction nearest to the unit vector `direction` in which a robot at `from_m` can drive
// `length_m` without meeting a wall near the lines; `direction` if there is none.
Vec2 off_walls(const Field& field, const Vec2& from_m, const Vec2& direction, double length_m);

// Extra distance from the ball if the rule book immediately penalises being too near (2026);
// otherwise 0.
double room_for_error_m(const RuleBook& rules);

// The permitted position nearest to `wanted_m`, or one close to it. If the half, an area or the
// edge of the field leaves no space next to the ball, these limits take precedence over the
// distance from the ball.
Vec2 permitted(const Field& field, const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits);

// The same, but if there is no space, the result is a position farther around the ball that
// respects all limits.
Vec2 permitted_by_all(const Field& field, const Vec2& wanted_m, const Vec2& ball_m,
                      const Limits& limits);

}  // namespace autoref::strategies
