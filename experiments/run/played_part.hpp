// Plays a part of a game and measures it, to estimate how long whole games take.
#pragma once

#include <array>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/loop/team_controller.hpp"

namespace autoref::experiments {

// What playing a game, or its beginning, showed: the share that was played, parts of the wall time
// taken, and why the game is void.
struct PlayedPart {
  double share = 1;  // share of the game that was played, above 0
  // Wall time before the first frame, for example to start programs.
  double start_s = 0;
  // Wall time of teams a and b: to start them and to let them decide.
  std::array<double, 2> team_s{};
  std::string void_reason = {};  // empty unless the game is void
};

// Plays the game to its end or until it has taken `most_wall_s`, but at least until its clock has
// started to run or for one second. The share played is relative to the duration of the halves (or
// of the scene). Throws like the constructor of Game.
PlayedPart play_part(const game::GameConfiguration& game, double most_wall_s,
                     const game::TeamMaker& make_team);

}  // namespace autoref::experiments
