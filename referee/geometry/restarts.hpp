// Where the ball is placed for each restart (paper, section 4.2; Laws 2014, laws 9 and 13; 2026,
// Free Kick).
//
// Every position is symmetric: if the sides are swapped and the input is rotated by 180 degrees,
// the result is rotated too. A point exactly on the long axis of the field counts as left of the
// axis, as seen by the kicking side.
#pragma once

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// The position 100 mm inside the touch line, level with `exit_m`, where the ball left the field.
Vec2 throw_in_position(const Field& field, const RuleBook& rules, const Vec2& exit_m);

// The position 100 mm from the goal line that the ball crossed at `exit_m` and from the nearest
// touch line.
Vec2 corner_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                          const Vec2& exit_m);

// The position 500 mm from the goal line that the ball crossed at `exit_m`, and 100 mm from the
// nearest touch line.
Vec2 goal_kick_position(const Field& field, const RuleBook& rules, Side kicker, const Vec2& exit_m);

// The position of a free kick by `kicker` for an offence at `where_m`: the position of the offence,
// moved to at least 100 mm inside the lines. If that is inside the kicker's own defence area, the
// free kick is taken 600 mm from the goal line and 100 mm from the touch line. If it is within 700
// mm of the opponents' area, it is moved away from their goal line until it is 700 mm from the
// area. Under the rules of 2026, it is the closest position to the offence that is at least 0.2 m
// inside the lines and 1 m from both areas.
Vec2 free_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                        const Vec2& where_m);

// `where_m`, moved to at least 100 mm inside the lines and then along the field's long axis until
// it is at least 700 mm from both defence areas.
Vec2 neutral_position(const Field& field, const RuleBook& rules, const Vec2& where_m);

// Whether a ball that rests at `ball_m` can stay there for a restart at `target_m` (2026, Ball
// Placement: "No ball placement is required if ...").
bool ball_may_stay(const Field& field, const RuleBook& rules, const Vec2& ball_m,
                   const Vec2& target_m);

// Whether robots cannot get the ball (2026, Ball Placement: "The ball ... must not be inside a
// field corner, a goal corner or behind the goal").
bool is_out_of_reach(const Field& field, const RuleBook& rules, const Vec2& ball_m);

}  // namespace autoref::referee
