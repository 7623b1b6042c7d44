// The sections of a style's list of tunables, which tunables() in style.hpp joins.
#pragma once

#include <span>

#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

std::span<const Tunable> moving_tunables();      // driving, and distances required by the rules
std::span<const Tunable> kick_tunables();        // values and execution of kicks
std::span<const Tunable> ball_tunables();        // the robot at the ball
std::span<const Tunable> running_tunables();     // positions of receivers
std::span<const Tunable> defence_tunables();     // wall, markers and keeper
std::span<const Tunable> together_tunables();    // covering the goal together, restarts, turning
std::span<const Tunable> discipline_tunables();  // avoiding fouls
std::span<const Tunable> play_tunables();        // assignment of roles
std::span<const Tunable> formation_tunables();   // formations of individual teams

}  // namespace autoref::strategies
