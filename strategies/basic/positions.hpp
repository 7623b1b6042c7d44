// Positions of `basic`'s robots that do not play the ball.
#pragma once

#include "soccer/field.hpp"
#include "soccer/team_view.hpp"
#include "strategies/basic/style.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies::basic {

// The keeper's position: in the path of a shot, otherwise between the ball and the goal's centre.
Waypoint keeper_position(const Field& field, const Style& style, const TrackedBall& ball);

// A position in front of the team's own area, on the line from the ball to the goal's centre. The
// second robot (`order` 1) stands beside the first.
Waypoint wall_position(const Field& field, const Style& style, const Vec2& ball_m, int order);

// A position close to an opponent, on its path to the team's own goal, facing the ball.
Waypoint marker_position(const Field& field, const Style& style, const TrackedRobot& opponent,
                         const Vec2& ball_m);

// A position from which a robot can receive a pass or a rebound. The first supporter stands on the
// side away from the ball; the others are spread along and across the field. `order` counts from 0.
Waypoint supporter_position(const Field& field, const Style& style, const Vec2& ball_m, int order);

// A separate position in the team's own half for each robot beyond the first four while play is
// stopped. `index` counts from 0.
Waypoint reserve_position(const Field& field, const Vec2& ball_m, int index);

}  // namespace autoref::strategies::basic
