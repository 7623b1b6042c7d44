// The plans of the teams that are made of skills, tactics and plays.
#pragma once

#include "strategies/plays/squad.hpp"

namespace autoref::strategies {

// The strong team: it gets to the ball first, passes to where a first-time shot is open, and covers
// its goal's open angles.
TeamPlaybook cobalt_playbook();

// Counter-attack: a deep block behind the ball, one or two ahead who get it long and at once.
TeamPlaybook counter_playbook();

// The ball's keeper: short safe passes within a net of receivers; shoots at clear chances only.
TeamPlaybook possession_playbook();

// Man-marking all over the field: each robot follows its own opponent, one goes to the ball.
TeamPlaybook shadow_playbook();

// A fixed formation that shifts with the ball; only the fastest leaves its zone for the ball.
TeamPlaybook zone_playbook();

}  // namespace autoref::strategies
