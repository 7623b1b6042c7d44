// A knockout's bracket, with the results of its games.
#pragma once

#include <vector>

#include "experiments/kinds/knockout/bracket.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// The ties with their winners and the games played so far.
std::vector<Tie> bracket_of(const Knockout& knockout, const RowsById& rows);

// The games known so far: those that these ties have already played, and the next game of each
// undecided tie with two known teams.
//
// In ids, rows and seeds, the tie's number replaces the pair, and the attempt replaces the leg:
// "cobalt~zone-p0007-1", and after a draw "cobalt~zone-p0007-2". The better seed is team a and
// starts in the west; in each replay the teams change ends, and the other team kicks off first. All
// games of a tie belong to the same shard.
std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties);

}  // namespace autoref::experiments
