// Plays a part of a game and measures it, to estimate how long whole games take.
#pragma once

#include <array>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/loop/team_controller.hpp"

namespace autoref::experiments {

// The wall time that it took to play a game or its beginning.
struct PlayedPart {
  double share = 1;                // of the game that was played, above 0
  double start_s = 0;              // before the first frame, e.g. to start programs
  std::array<double, 2> team_s{};  // of teams a and b: to start them and for their decisions
  std::string void_reason = {};    // empty unless void
};

// Plays the game to its end or until it has taken `most_wall_s`, but at least until its clock has
// started to run or for one second. The share played is relative to the duration of the halves (or
// of the scene). Throws like the constructor of Game.
PlayedPart play_part(const game::GameConfiguration& game, double most_wall_s,
                     const game::TeamMaker& make_team);

}  // namespace autoref::experiments
