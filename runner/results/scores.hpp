// Who won a game, by its row.
#pragma once

#include <cstddef>

#include "runner/results/rows.hpp"

namespace autoref::runner {

// Where a row holds what a game's result is told by.
struct ScoreColumns {
  explicit ScoreColumns(const RowFormat& format);

  std::size_t goals_a, goals_b, status, end_reason, shootout_a, shootout_b, pair;
};

bool is_void(const Cells& row, const ScoreColumns& at);

// Above 0 where team a has won, below 0 where team b has: by goals, or by its shoot-out where a
// game has one; a team that gives up has lost. Not for void games.
double lead_of_a(const Cells& row, const ScoreColumns& at);

}  // namespace autoref::runner
