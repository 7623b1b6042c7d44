// SPRT matches: two teams play until a sequential test accepts one of two hypotheses.
#pragma once

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/named_teams.hpp"
#include "experiments/statistics/sequential_test.hpp"

namespace autoref::experiments {

struct SprtMatch : NamedTeams, ExperimentOf<SprtMatch> {  // two teams
  static const Kind kKind;

  SequentialTest sprt;  // tests the goal difference, team a minus team b

  std::vector<Key> keys() override;
  // The games of a round robin between the two teams with the maximum number of pairs. The test
  // usually ends the match earlier (sprt_match_state.hpp).
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  bool follows_its_rows() const override { return true; }
  Schedule schedule(const RowsById& rows) const override;
  bool is_decided(const RowsById& rows) const override;
  ExperimentResults results(const RowsById& rows) const override;
};

// Both teams, as in a round robin: team a is the first by name (compared as bytes).
Matchup matchup_of(const SprtMatch& match);

// Paths are "sprt.d0" and so on.
std::vector<game::Setting> sprt_settings_of(SequentialTest& test);

}  // namespace autoref::experiments
