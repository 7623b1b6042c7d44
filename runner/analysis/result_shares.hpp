// Fractions of games won, drawn and lost, with confidence intervals.
#pragma once

#include <array>
#include <string>

#include "runner/io/csv.hpp"

namespace autoref::runner {

// Numbers of games won, drawn and lost.
using ResultCounts = std::array<int, 3>;

// CSV columns for three counts with these names: first the counts, then for each count its fraction
// of all games and that fraction's 95 % interval, such as "wins_a_share", "wins_a_low95" and
// "wins_a_high95". The intervals are those of proportion_interval(), which assumes independent
// games. Without games, these cells are empty.
Cells share_columns(const std::array<std::string, 3>& names);
Cells share_cells(const ResultCounts& counts);

// "63 % [52, 73]": the fraction with its 95 % interval; "-" if `whole` is 0.
std::string share_text(int part, int whole);

}  // namespace autoref::runner
