// A ball in a goal: whose goal it is, the restart if the goal does not count, and the goal awarded
// for a foul by the defenders at a penalty kick (2026, Penalty Kick).
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"
#include "referee/touch/touch_history.hpp"

namespace autoref::referee {

// A kGoal finding for the kicker's side, wherever the ball is. Play must be a penalty kick.
Finding awarded_goal(const RefereeState& state, const RefereeInput& input);

// The side whose goal contains the ball, if any. A ball that has lain outside the field since
// before play began was not shot there.
std::optional<Side> conceding_side(const PlayState& play, const RefereeInput& input);

// Sets the kicker and position of the free kick that follows the finding's event: a goal kick for
// `defender`, or a corner kick at the defender's end.
void restart_with_goal_kick(Finding& finding, const RefereeInput& input, Side defender);
void restart_with_corner_kick(Finding& finding, const RefereeInput& input, Side defender);

// Greatest height of the ball's top since the scorers' last touch; nullopt if that touch is
// unknown.
std::optional<double> top_since_touch_m(const TouchHistory& touches, Side scorer);

// Adds details of the shot to a finding about a ball in a goal.
void add_shot(Finding& finding, const TouchHistory& touches, const RefereeInput& input,
              Side scorer);

}  // namespace autoref::referee
