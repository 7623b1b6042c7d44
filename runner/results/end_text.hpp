// Why a game ended, in words for a reader.
#pragma once

#include <string>

#include "runner/game/configuration.hpp"
#include "runner/game/game_record.hpp"

namespace autoref::runner {

// One line for each EndReason, and for each SceneEnd if the game was a scene; teams are named by
// colour and letter, such as "blue (b) leads by 9 goals". Forfeited and void games include the
// record's reason.
std::string end_text(const GameConfiguration& game, const GameRecord& record);

}  // namespace autoref::runner
