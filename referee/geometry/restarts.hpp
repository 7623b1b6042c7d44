// Where the ball is put for each restart (paper, section 4.2; Laws 2014, laws 9 and 13;
// 2026, Free Kick).
//
// Every place turns with the field: with the sides swapped and the point turned by 180 degrees, it
// is the turned place. Points exactly on the axis between the touch lines count as left of it, as
// the side that kicks sees it.
#pragma once

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// 100 mm inside the touch line where the ball left at `exit_m`.
Vec2 throw_in_position(const Field& field, const RuleBook& rules, const Vec2& exit_m);

// 100 mm from the goal line that the ball crossed at `exit_m` and from the nearest touch line.
Vec2 corner_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                          const Vec2& exit_m);

// 500 mm from the goal line that the ball crossed at `exit_m`, 100 mm from the nearest touch line.
Vec2 goal_kick_position(const Field& field, const RuleBook& rules, Side kicker, const Vec2& exit_m);

// For a free kick by `kicker` because of something at `where_m`: there, at least 100 mm inside
// the lines. Out of the kicker's own defence area it is moved to 600 mm from the goal line and
// 100 mm from the touch line; within 700 mm of the opponents' area it is moved away from their
// goal line until it is 700 mm from the area.
// 2026: at least 0.2 m inside the lines and 1 m from both areas, at the closest such place.
Vec2 free_kick_position(const Field& field, const RuleBook& rules, Side kicker,
                        const Vec2& where_m);

// The place nearest to `where_m` along the field at least 100 mm inside the lines and 700 mm from
// both defence areas.
Vec2 neutral_position(const Field& field, const RuleBook& rules, const Vec2& where_m);

}  // namespace autoref::referee
