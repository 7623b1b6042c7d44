// How a run plays its games and displays its results so far.
#pragma once

#include <functional>

#include "experiments/results/game_row.hpp"
#include "io/processes/progress.hpp"

namespace autoref::experiments {

struct Outcomes {
  // Plays the game in a worker and fills the row's record (and evaluation). May throw.
  std::function<void(const game::GameConfiguration& game, GameRow& row)> play;
  std::function<io::ProgressView(const RowsById& rows)> view;  // of the results so far
};

}  // namespace autoref::experiments
