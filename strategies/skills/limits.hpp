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
  double from_m = 1.2;      // gap between hulls below which the closing speed is limited
  double gentle_mps = 0.2;  // closing speed allowed at contact
  // Deceleration that determines the closing speed allowed at a given distance.
  double braking_mps2 = 1.2;
  double contact_mps = 100.0;  // largest speed towards an opponent in contact; the default is no
                               // limit, since no robot is that fast
};

// Limits the closing speed of `robot` towards each nearby opponent to a braking curve over the gap.
// Only the component towards the opponent is reduced, so the robot can still slide past it.
void ease_off(const TrackedRobot& robot, const TrackedRobots& opponents, const Easing& easing,
              RobotCommand& command);

// Added to the distances in the rules to allow for the robots' own errors; the second one if a
// robot stands as near to a limit as it can.
inline constexpr double kLimitMargin_m = 30_mm;
inline constexpr double kNarrowMargin_m = 10_mm;

// The limits that currently apply to a robot's position.
struct Limits {
  bool own_half_only = false;   // whether the robot must stay in its own half, before a kick-off
  double keep_from_ball_m = 0;  // minimum distance from the robot's centre to the ball
  // Minimum distance from the robot's centre to the opponents' defence area.
  double keep_from_area_m = 0;
  bool may_enter_own_area = false;            // true for the keeper
  double own_area_margin_m = kLimitMargin_m;  // gap between the hull and the team's own area
  // Whether to keep a position that is behind the goal line, even if it is too near to a
  // quarter-circle area. `basic` relies on this, and the benchmark's games depend on it.
  bool may_stay_behind_goal = false;
  double beyond_lines_m = 90_mm;  // how far a robot's centre may be outside the field
};

// The largest |x| and |y| that a robot's centre can have if there are walls near the lines;
// infinite if the run-off is wide enough to keep the distance that the rules require from a ball on
// a line.
Vec2 farthest_between_walls_m(const Field& field);

// The direction nearest to the unit vector `direction` in which a robot at `from_m` can drive
// `length_m` without hitting a wall near the lines; `direction` if there is no such direction.
Vec2 off_walls(const Field& field, const Vec2& from_m, const Vec2& direction, double length_m);

// Extra distance from the ball if the rule book immediately penalises robots that are too near to
// it (2026); otherwise 0.
double room_for_error_m(const RuleBook& rules);

// The permitted position nearest to `wanted_m`, or one close to it. If the halfway line, an area or
// the edge of the field leaves no space next to the ball, the limits from these take precedence
// over the distance from the ball.
Vec2 permitted(const Field& field, const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits);

// The same as permitted(), but if there is no space next to the ball, the result is a position
// farther around the ball that respects all limits.
Vec2 permitted_by_all(const Field& field, const Vec2& wanted_m, const Vec2& ball_m,
                      const Limits& limits);

}  // namespace autoref::strategies
