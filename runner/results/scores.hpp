// Who won a game.
#pragma once

#include <string>

#include "runner/game/game.hpp"

namespace autoref::runner {

bool is_void(const GameRecord& record);

// Positive if team a won, negative if team b did: by goals, or by the shoot-out if there was one. A
// forfeit is a loss whatever the score. Not meaningful for void games.
double lead_of_a(const GameRecord& record);

// "3:1", "1:1 (4:2)" with a shoot-out, "void".
std::string score_text(const GameRecord& record);

}  // namespace autoref::runner
