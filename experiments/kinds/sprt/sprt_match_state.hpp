// State of an SPRT match, computed from its rows.
#pragma once

#include "experiments/kinds/sprt/sprt_match.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/statistics/sequential_test.hpp"

namespace autoref::experiments {

struct SprtMatchState {
  SequentialState test;     // kUndecided if there is no decision after max_pairs
  int last_pair = 0;        // number of the last pair considered
  int void_pairs = 0;       // number of pairs up to last_pair with a void leg
  bool is_decided = false;  // no further pairs are needed
};

// Considers pairs by ascending number, until one lacks a row or decides the match. The verdict
// therefore depends neither on the number of workers nor on games played after the deciding pair.
// Pairs with a void leg are left out of the test.
SprtMatchState state_of(const SprtMatch& match, const RowsById& rows);

}  // namespace autoref::experiments
