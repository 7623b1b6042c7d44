// Who won a game.
#pragma once

#include <string>

#include "game/loop/game.hpp"

namespace autoref::experiments {

bool is_void(const game::GameRecord& record);

// Positive if team a won, negative if team b did: by goals, or by the shoot-out if there was one. A
// forfeit is a loss whatever the score. Not meaningful for void games.
double lead_of_a(const game::GameRecord& record);

// "3:1", "1:1 (4:2)" with a shoot-out, "void".
std::string score_text(const game::GameRecord& record);

}  // namespace autoref::experiments
