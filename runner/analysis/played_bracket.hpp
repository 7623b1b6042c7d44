// The bracket of a knockout as its games' rows decide it.
#pragma once

#include <vector>

#include "runner/experiments/bracket.hpp"
#include "runner/results/rows.hpp"

namespace autoref::runner {

// The ties with the games played so far, and who won them.
std::vector<Tie> bracket_of(const Knockout& knockout, const RowFormat& format,
                            const RowsById& rows);

}  // namespace autoref::runner
