// Why a game ended, in words for a reader.
#pragma once

#include <string>

#include "game/loop/configuration.hpp"
#include "game/loop/game_record.hpp"

namespace autoref::experiments {

// One line for each EndReason, and for each SceneEnd if the game was a scene; teams are named by
// colour and letter, such as "blue (b) leads by 9 goals". Forfeited and void games include the
// record's reason.
std::string end_text(const game::GameConfiguration& game, const game::GameRecord& record);

}  // namespace autoref::experiments
