// What rows keep of a game, and how a run shows them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runner/game/game.hpp"
#include "runner/results/rows.hpp"

namespace autoref::runner {

struct Outcomes {
  std::function<Cells(const GameConfiguration&)> of_game;   // called in workers; may throw
  std::function<Cells(const std::string& reason)> of_void;  // of a game that went wrong
  std::function<std::string(const Cells& row)> news;        // what a game came to; may be empty
  std::function<std::string(const std::vector<Cells>& rows)> table;  // of the games so far
};

}  // namespace autoref::runner
