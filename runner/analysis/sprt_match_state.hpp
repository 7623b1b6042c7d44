// How a match stands, from its games' rows.
#pragma once

#include "runner/experiments/sprt_match.hpp"
#include "runner/results/game_row.hpp"
#include "runner/statistics/sequential_test.hpp"

namespace autoref::runner {

struct SprtMatchState {
  SequentialState test;     // by the first pairs; kUndecided where max_pairs did not do
  int last_pair = 0;        // so many pairs tell it, from the first, each with both of its rows
  int void_pairs = 0;       // of these, with a void leg
  bool is_decided = false;  // no further pair is needed
};

// The pairs are taken in the order of their numbers, up to the first that has not both rows, or to
// the one that decides: so that the verdict depends neither on the number of workers nor on games
// that were played beyond it. A pair with a void leg is left out of the test.
SprtMatchState state_of(const SprtMatch& match, const RowsById& rows);

}  // namespace autoref::runner
