// A knockout's bracket as its games decide it.
#pragma once

#include <vector>

#include "runner/experiments/bracket.hpp"
#include "runner/results/game_row.hpp"

namespace autoref::runner {

// The ties with the games played so far, and who won them.
std::vector<Tie> bracket_of(const Knockout& knockout, const RowsById& rows);

}  // namespace autoref::runner
