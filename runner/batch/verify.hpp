// Games of a folder played again, to see whether they come out as their rows say.
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

// A game that did not come out as before, and the first column that tells.
struct Difference {
  std::string id;
  std::string column;
  std::string stored;
  std::string now;
};

struct Verification {
  int played = 0;
  std::vector<Difference> differences;
};

// Up to `sample` games of the folder, spread evenly over its rows that are not void, in workers.
// `outcome` gives what rows keep of a game. Throws Interrupted where the user does, and InputError
// where there are no such rows.
Verification verify(const ResultFolder& folder, int sample, int workers,
                    const std::function<Cells(const GameConfiguration&)>& outcome,
                    std::FILE* progress);

// Likewise of games whose records are kept.
Verification verify(const ResultFolder& folder, int sample, int workers,
                    const std::function<GameRecord(const GameConfiguration&)>& play,
                    std::FILE* progress);

}  // namespace autoref::runner
