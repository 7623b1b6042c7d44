// The time from a restart's signal until the ball is in play ("once it has moved 50 mm", Laws 2014,
// laws 8, 9 and 13), and the ball's history since.
#pragma once

#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The state of play right after `command` started it. `kicker` takes the restart; nullopt for a
// force start.
PlayState play_begun(Command command, std::optional<Side> kicker, const RefereeInput& input);

// The state of play if it is on, but its beginning was not seen: the ball is in play, and nothing
// is known of earlier touches.
PlayState play_joined(const RefereeInput& input);

// Updates the state with one frame of RUN.
void watch_play(PlayState& play, const RefereeInput& input);

// How far the ball is from the halfway line towards the goal that the kicker attacks, in metres.
// The ball must have been seen.
double goalwards_m(const PlayState& play, const RefereeInput& input);

// Whether the restart was a kick-off or a penalty kick. NORMAL_START starts both; only the kick-off
// is taken from the centre.
bool began_with_kickoff(const PlayState& play, const Field& field);
bool began_with_penalty(const PlayState& play, const Field& field);

// Whether the ball comes straight from the restart: only its kicker has touched it. A touch by an
// unknown robot may have been made by a second robot.
bool is_straight_from_restart(const PlayState& play);

}  // namespace autoref::referee
