// Where the robots of `basic` stand when they do not play the ball.
#pragma once

#include "soccer/field.hpp"
#include "soccer/team_view.hpp"
#include "strategies/basic/style.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies::basic {

// The keeper: on the ball's way into the goal, else between the ball and the goal's middle.
Waypoint keeper_position(const Field& field, const Style& style, const TrackedBall& ball);

// In front of the own area, on the line from the ball to the goal's middle; the second robot
// (`order` 1) beside the first.
Waypoint wall_position(const Field& field, const Style& style, const Vec2& ball_m, int order);

// Beside an opponent, on its way to the own goal, facing the ball.
Waypoint marker_position(const Field& field, const Style& style, const TrackedRobot& opponent,
                         const Vec2& ball_m);

// Ready for a pass or a rebound: the first on the side away from the ball, the others spread up and
// across the field. `order` counts from 0.
Waypoint supporter_position(const Field& field, const Style& style, const Vec2& ball_m, int order);

// A place of its own for each robot beyond the first four while play is stopped, `index` counting
// from 0, across the own half.
Waypoint reserve_position(const Field& field, const Vec2& ball_m, int index);

}  // namespace autoref::strategies::basic
