// Gauntlets: challengers against a fixed field of teams.
#pragma once

#include <optional>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/team_versions.hpp"

namespace autoref::experiments {

struct Gauntlet : NamedTeams, ExperimentOf<Gauntlet> {  // `teams` is the field
  static const Kind kKind;

  Teams challengers;      // no challenger has the name of a team of the field
  TeamVersions versions;  // of the challengers
  int pairs = 1;          // pairs of legs per matchup, 1 to 9999

  std::vector<Key> keys() override;
  std::optional<VersionedTeams> versioned_teams() override;
  // A gauntlet's game equals the corresponding round-robin game if the challenger's name sorts
  // before its opponent's (compared as bytes); otherwise teams a and b are swapped.
  std::vector<ScheduledGame> games() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

// Pairs every challenger that is played, as team a, with every team of the field, in the order of
// their names. Challengers do not play each other, and neither do the teams of the field.
std::vector<Matchup> matchups_of(const Gauntlet& gauntlet);

}  // namespace autoref::experiments
