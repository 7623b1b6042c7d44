// Where the robots stand at a penalty until the ball is in play.
#pragma once

#include "soccer/field.hpp"
#include "soccer/team_view.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// The robot that takes the penalty, by index in the view: of those that do not keep the goal the
// one nearest to the mark; -1 without robots.
int penalty_kicker(const TeamView& view, const Vec2& mark_m);

// Behind the ball, facing the opponents' goal.
Waypoint penalty_run_up(const Vec2& mark_m);

// On the own goal line between the posts, facing the ball.
Waypoint penalty_keeper(const Field& field, const Vec2& mark_m);

// Behind the line through the mark, on the side away from the goal shot at, a little farther than
// `clearance_m` from hull to line; defenders in a row behind the attackers'. `order` counts from 0.
Waypoint penalty_spectator(const Field& field, const Vec2& mark_m, double clearance_m, bool ours,
                           int order);

}  // namespace autoref::strategies
