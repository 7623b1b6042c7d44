// The report of a game, as printed by `autoref play`.
#pragma once

#include <string>
#include <string_view>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"

namespace autoref::experiments {

// Why a game ended, in plain words. Each EndReason has its own sentence and, if the game was a
// scene, so has each SceneEnd. Teams are named by colour and letter, such as "blue (b) leads by 9
// goals". Forfeited and void games include the record's reason.
std::string end_text(const game::GameConfiguration& game, const game::GameRecord& record);

struct GameReport {
  const game::GameConfiguration& configuration;
  const game::GameRecord& record;
  double wall_s = 0;
  std::string_view build;
  bool is_interrupted = false;  // then the record is that of the frames so far
};

// The report as a JSON object on one line.
std::string json_of(const GameReport& report);

// The report as a few lines of text.
std::string text_of(const GameReport& report);

}  // namespace autoref::experiments
