// Plays a part of a game and measures it, to estimate how long whole games take.
#pragma once

#include <array>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/loop/team_controller.hpp"

namespace autoref::experiments {

// What playing a game, or its beginning, has taken in wall time.
struct PlayedPart {
  double share = 1;                // of the game that was played, above 0
  double start_s = 0;              // before the first frame, such as to start the teams' programs
  std::array<double, 2> team_s{};  // of teams a and b: to start them and for their decisions
  std::string void_reason = {};    // empty unless void
};

// Plays the game to its end, or until it has taken `most_wall_s`: then at least until its clock has
// run, or for one second. The share that was played is that of the halves' time (of a scene's
// duration). Throws like the constructor of Game.
PlayedPart play_part(const game::GameConfiguration& game, double most_wall_s,
                     const game::TeamMaker& make_team);

}  // namespace autoref::experiments
