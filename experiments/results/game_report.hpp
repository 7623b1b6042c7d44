// The report of a game, as printed by `autoref play`.
#pragma once

#include <string>
#include <string_view>

#include "game/loop/game.hpp"

namespace autoref::experiments {

struct GameReport {
  const game::GameConfiguration& configuration;
  const game::GameRecord& record;
  double wall_s = 0;
  std::string_view build;
};

// One JSON object on one line.
std::string json_of(const GameReport& report);

// A few lines of text.
std::string text_of(const GameReport& report);

}  // namespace autoref::experiments
