// The parts of a style's list of numbers, each with its unit, range and one sentence; tunables() in
// style.hpp is all of them.
#pragma once

#include <span>

#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

std::span<const Tunable> moving_tunables();     // driving, and the rules' distances
std::span<const Tunable> kick_tunables();       // what a kick is worth, and how it is made
std::span<const Tunable> ball_tunables();       // the robot at the ball
std::span<const Tunable> running_tunables();    // where receivers go
std::span<const Tunable> defence_tunables();    // wall, markers and keeper
std::span<const Tunable> play_tunables();       // who does what
std::span<const Tunable> formation_tunables();  // the teams' own formations

}  // namespace autoref::strategies
