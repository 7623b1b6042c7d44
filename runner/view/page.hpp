// Renders a game as a self-contained HTML page.
#pragma once

#include <string>
#include <vector>

#include "runner/view/game_recording.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

struct PageFact {
  std::string what;
  std::string value;
};

struct PageContent {
  const GameRecording& recording;
  Field field;
  PerSide<std::string> names;     // of the teams; empty if unknown
  std::vector<PageFact> facts{};  // shown below the game, such as {"build", "0.1.0-..."}
};

// The page: HTML with style, script (runner/view/page/) and the game's data.
std::string page_of(const PageContent& content);

}  // namespace autoref::runner
