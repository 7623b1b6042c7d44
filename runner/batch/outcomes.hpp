// How a run plays its games and displays its results so far.
#pragma once

#include <functional>

#include "runner/processes/progress.hpp"
#include "runner/results/game_row.hpp"

namespace autoref::runner {

struct Outcomes {
  // Plays the game in a worker and fills the row's record (and evaluation). May throw.
  std::function<void(const GameConfiguration& game, GameRow& row)> play;
  std::function<ProgressView(const RowsById& rows)> view;  // of the results so far
};

}  // namespace autoref::runner
