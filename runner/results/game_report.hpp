// The report of a game, as printed by `autoref play`.
#pragma once

#include <string>
#include <string_view>

#include "runner/game/game.hpp"

namespace autoref::runner {

struct GameReport {
  const GameConfiguration& configuration;
  const GameRecord& record;
  double wall_s = 0;
  std::string_view build;
};

// One JSON object on one line.
std::string json_of(const GameReport& report);

// A few lines of text.
std::string text_of(const GameReport& report);

}  // namespace autoref::runner
