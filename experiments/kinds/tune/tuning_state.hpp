// State of a tuning, computed from its rows by repeating the search.
#pragma once

#include <optional>
#include <vector>

#include "experiments/kinds/tune/tuning_schedule.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sequential_test.hpp"

namespace autoref::experiments {

struct TuningIteration {
  int number = 1;
  Point centre;                       // centre of the search before the iteration
  std::vector<Candidate> candidates;  // and their scores in goals per game. In self-play, only
  std::vector<Score> scores;          // differences between the scores are meaningful
  double reach = 0;                   // distance of the candidates from the centre, in steps
  ParamValues after;                  // parameter values at the centre after the iteration,
  ParamValues best;                   // and the best parameter values known after it
};

// The sequential test that compares the result with the start.
struct TuningTest {
  ThreeWayState state;  // kUndecided after max_pairs
  int last_pair = 0;    // number of the last pair considered
  // Number of pairs up to last_pair that are left out because a game is void.
  int void_pairs = 0;
  // Mean gain in the deciding pairs, in goals per game.
  std::optional<double> gain;
  std::optional<Interval> interval;  // anytime_interval()
  bool is_decided = false;
};

struct TuningState {
  std::vector<TuningIteration> path;  // all iterations whose games have all been played
  // The iteration that is being played; nullopt after the last one.
  std::optional<TuningIteration> current;
  ParamValues best;  // best parameter values known so far
  TuningTest test;

  bool is_tuned() const { return !current; }
};

// Considers iterations in order until one lacks a row, so the state depends neither on the number
// of workers nor on the order of the rows. A game counts as missing if its worker was killed, since
// it will be replayed. Other void games are left out of the scores together with their pair.
TuningState state_of(const Tuning& tuning, const RowsById& rows);

// Returns whether the final test is decided. Faster than state_of() as long as the search is still
// running.
bool is_test_decided(const Tuning& tuning, const RowsById& rows);

// The games known so far: the games of all iterations in the state and, after the last iteration,
// those of the test.
std::vector<ScheduledGame> known_games(const Tuning& tuning, const TuningState& state);

}  // namespace autoref::experiments
