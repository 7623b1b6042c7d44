// Decides when the ball is in play after a restart's signal ("once it has moved 50 mm", Laws 2014,
// laws 8, 9 and 13), records the ball's history from then on, and handles retakes of restarts.
#pragma once

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The state of play right after `command` started it. `kicker` takes the restart; nullopt for a
// force start.
PlayState play_begun(Command command, std::optional<Side> kicker, const RefereeInput& input);

// The state of play if play is on but its start was not seen: the ball is in play, and earlier
// touches are unknown.
PlayState play_joined(const RefereeInput& input);

// Updates the state with one frame in the state RUN.
void watch_play(PlayState& play, const RefereeInput& input);

// How far the ball is from the halfway line towards the goal that the kicker attacks, in metres.
// The ball must have been seen.
double goalwards_m(const PlayState& play, const RefereeInput& input);

// Whether the restart was a kick-off or a penalty kick. NORMAL_START starts both; only the kick-off
// is taken from the centre.
bool began_with_kickoff(const PlayState& play, const Field& field);
bool began_with_penalty(const PlayState& play, const Field& field);

// Whether the ball comes straight from the restart, so only the kicker has touched it. A touch by
// an unknown robot may have been made by a second robot.
bool is_straight_from_restart(const PlayState& play);

// Restarts that are retaken because their own rules were broken: opponents too near, robots in the
// wrong half, robots out of position at a penalty kick (Laws 8, 13 and 14).

// Whether the current restart can be retaken (RuleBook::retakes). If not, play continues.
bool may_be_taken_again(const RefereeState& state, const RuleBook& rules);

// Makes the finding's restart a retake of the current restart, from the same position.
void take_again(Finding& finding, const PlayState& play);

// Makes the finding's restart the one that is about to be taken, from the same position; returns
// false if there is none. The league's game controller does this with kick-offs and penalty kicks.
bool keep_restart(Finding& finding, const RefereeState& state);

// The number and kind of retakes to record after the finding has stopped play; none if a different
// restart follows.
Retakes retakes_after(const Retakes& before, const Finding& finding);

}  // namespace autoref::referee
