// A knockout's bracket, with the results of its games.
#pragma once

#include <vector>

#include "runner/experiments/bracket.hpp"
#include "runner/results/game_row.hpp"

namespace autoref::runner {

// The ties with their winners and the games played so far.
std::vector<Tie> bracket_of(const Knockout& knockout, const RowsById& rows);

}  // namespace autoref::runner
