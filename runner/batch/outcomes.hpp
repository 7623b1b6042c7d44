// What rows keep of a game, and how a run shows them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/game/game.hpp"
#include "runner/processes/progress.hpp"
#include "runner/results/rows.hpp"

namespace autoref::runner {

struct Outcomes {
  std::function<Cells(const GameConfiguration&)> of_game;            // called in workers; may throw
  std::function<Cells(const std::string& reason)> of_void;           // of a game that went wrong
  std::function<ProgressView(const std::vector<Cells>& rows)> view;  // of the games so far
};

}  // namespace autoref::runner
