// The playbooks of the teams that are built from skills, tactics and plays.
#pragma once

#include "strategies/plays/squad.hpp"

namespace autoref::strategies {

// The strong team. It dribbles straight at the goal, passes where that is better, covers its goal
// with wall and keeper together, and avoids fouls.
TeamPlaybook cobalt_playbook();

// The previous version of the strong team, kept for comparison: its games never change.
TeamPlaybook cobalt1_playbook();

// Counter-attack: a deep block behind the ball, and long, immediate passes to one or two forwards.
TeamPlaybook counter_playbook();

// Possession: short, safe passes within a net of receivers; shoots only at clear chances.
TeamPlaybook possession_playbook();

// Man-marking all over the field: each robot follows its own opponent, and one goes for the ball.
TeamPlaybook shadow_playbook();

// A fixed formation that shifts with the ball; only the fastest robot leaves its zone for the ball.
TeamPlaybook zone_playbook();

}  // namespace autoref::strategies
