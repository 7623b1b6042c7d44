// SPRT matches: two teams play until a sequential test accepts one of two hypotheses. Contains
// their state and their results as a CSV file and as a text table.
#pragma once

#include <string>

#include "experiments/analysis/groups.hpp"
#include "experiments/kinds/experiment.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/statistics/sequential_test.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

struct SprtMatch : NamedTeams, ExperimentOf<SprtMatch> {  // two teams
  static const Kind kKind;

  SequentialTest sprt;  // tests the goal difference, team a minus team b

  std::vector<Key> keys() override;
  // The games of a round robin between the two teams, with the maximum number of pairs. The test
  // usually ends the match before all of them are played.
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  bool follows_its_rows() const override { return true; }
  Schedule schedule(const RowsById& rows) const override;
  bool is_decided(const RowsById& rows) const override;
  ExperimentResults results(const RowsById& rows) const override;
};

// The matchup of both teams, as in a round robin: team a is the first by name (compared as bytes).
Matchup matchup_of(const SprtMatch& match);

// The settings of the sequential test, with paths such as "sprt.d0".
std::vector<game::Setting> sprt_settings_of(SequentialTest& test);

// State of an SPRT match, computed from its rows.
struct SprtMatchState {
  SequentialState test;     // kUndecided if there is no decision after max_pairs
  int last_pair = 0;        // number of the last pair considered
  int void_pairs = 0;       // number of pairs up to last_pair with a void leg
  bool is_decided = false;  // whether no further pairs are needed
};

// Considers pairs by ascending number until one lacks a row or decides the match. The verdict
// therefore depends neither on the number of workers nor on games played after the deciding pair.
// Pairs with a void leg are left out of the test.
SprtMatchState state_of(const SprtMatch& match, const RowsById& rows);

// "d0", "d1", "undecided", or "none" while more pairs are needed.
std::string name_of(Verdict verdict);

// summary.csv: the matchup's row as in a round robin, followed by the columns of the test. These
// are its verdict, the number of pairs used, the number of pairs left out because of a void leg,
// the log-likelihood ratio of d1 to d0, and the test's settings.
std::string sprt_match_csv(const SprtMatch& match, const Group& matchup,
                           const SprtMatchState& state);

// The verdict as a sentence, then the number of pairs, the log-likelihood ratio and its bounds.
std::string verdict_text(const SprtMatch& match, const SprtMatchState& state);

// The matchup's table, followed by the verdict.
io::TextBlocks sprt_match_table(const SprtMatch& match, const Group& matchup,
                                const SprtMatchState& state);

}  // namespace autoref::experiments
