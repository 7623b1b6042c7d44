// Replays games of a results folder and compares them with their rows.
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "experiments/run/result_folder.hpp"
#include "game/loop/game.hpp"

namespace autoref::experiments {

// A game whose replay differs from its row, and the first column in which they differ.
struct Difference {
  std::string id;
  ColumnDifference column;  // `first` is the stored value, `second` the replayed one
};

struct Verification {
  int played = 0;
  std::vector<Difference> differences;
};

// Replays up to `sample` games of the folder in workers, spread evenly over its rows that are
// neither void nor forfeited. `play` fills the row's record (and evaluation). Throws Interrupted if
// the user interrupts, and InputError if all rows are void or forfeited.
Verification verify(const ResultFolder& folder, int sample, int workers,
                    const std::function<void(const game::GameConfiguration&, GameRow&)>& play,
                    std::FILE* progress);

}  // namespace autoref::experiments
