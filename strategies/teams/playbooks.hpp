// The playbooks of the teams that are built from skills, tactics and plays.
#pragma once

#include "strategies/plays/squad.hpp"

namespace autoref::strategies {

// The strong team. It dribbles straight at the goal, passes where that is better, covers its goal
// with the wall and the keeper together, and avoids fouls.
TeamPlaybook cobalt_playbook();

// The previous version of the strong team, kept for comparison: its behaviour never changes.
TeamPlaybook cobalt1_playbook();

// A counter-attacking team: it defends deep behind the ball, and immediately plays long passes to
// one or two forwards.
TeamPlaybook counter_playbook();

// A possession team: it plays short, safe passes within a net of receivers, and shoots only at
// clear chances.
TeamPlaybook possession_playbook();

// A man-marking team: all over the field, each robot follows its own opponent, and one robot goes
// for the ball.
TeamPlaybook shadow_playbook();

// A team with a fixed formation that shifts with the ball. Only the robot that can reach the ball
// first leaves its zone.
TeamPlaybook zone_playbook();

}  // namespace autoref::strategies
