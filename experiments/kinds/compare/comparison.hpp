// Comparisons: is a new team better than an old one? Both play each other, and common opponents if
// there are any, until the difference is known well enough.
#pragma once

#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/statistics/anytime_interval.hpp"

namespace autoref::experiments {

// The names of the two teams, and of the mean over all opponents, which no opponent may have.
inline constexpr const char* kOldTeam = "old";
inline constexpr const char* kNewTeam = "new";
inline constexpr const char* kAllOpponents = "all";

// Of the smallest difference that matters, in goals per game; above 0.
inline constexpr Range kLeastDifference = {0, 50, true};

struct Comparison : NamedTeams, ExperimentOf<Comparison> {  // `teams` are old and new
  static const Kind kKind;

  Teams against;        // common opponents, which both teams play; none is called old, new or all
  ComparisonTest test;  // of the new team's goal difference minus the old team's

  std::vector<Key> keys() override;
  // The games with the maximum number of pairs. The test usually ends the comparison before all of
  // them are played. Equal pair numbers have equal seeds against every opponent.
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  bool follows_its_rows() const override { return true; }
  Schedule schedule(const RowsById& rows) const override;
  bool is_decided(const RowsById& rows) const override;
  ExperimentResults results(const RowsById& rows) const override;
};

// The new team against the old one, then for each common opponent the new team against it and the
// old team against it.
std::vector<Matchup> matchups_of(const Comparison& comparison);

// The settings of the test, with paths such as "test.least".
std::vector<game::Setting> settings_of(ComparisonTest& test);

}  // namespace autoref::experiments
