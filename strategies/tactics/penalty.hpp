// Positions at a penalty kick until the ball is in play.
#pragma once

#include "soccer/field.hpp"
#include "soccer/team_view.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// The penalty taker, as an index in the view: the robot nearest to the penalty mark, except the
// keeper; -1 if there are no robots.
int penalty_kicker(const TeamView& view, const Vec2& mark_m);

// The kicker's position behind the ball, facing the opponents' goal.
Waypoint penalty_run_up(const Vec2& mark_m);

// The keeper's position on the team's own goal line between the posts, facing the ball.
Waypoint penalty_keeper(const Field& field, const Vec2& mark_m);

// A position behind the line through the mark, as seen from the goal that is attacked. The robot's
// hull is slightly farther than `clearance_m` from the line. The defenders stand in a row behind
// the attackers. `order` counts from 0.
Waypoint penalty_spectator(const Field& field, const Vec2& mark_m, double clearance_m, bool ours,
                           int order);

}  // namespace autoref::strategies
