// Games won, drawn and lost as shares, with what those are known to.
#pragma once

#include <array>
#include <string>

#include "runner/io/csv.hpp"

namespace autoref::runner {

// Of games won, drawn and lost.
using ResultCounts = std::array<int, 3>;

// What a CSV says of three counts whose columns have these names: first the counts, then for each
// its share of all games and the 95 % interval of that (proportion_interval(), games taken as
// independent), such as "wins_a_share", "wins_a_low95" and "wins_a_high95". Cells are empty where
// there are no games.
Cells share_columns(const std::array<std::string, 3>& names);
Cells share_cells(const ResultCounts& counts);

// "63 % [52, 73]" for people; "-" for none of none.
std::string share_text(int part, int whole);

}  // namespace autoref::runner
