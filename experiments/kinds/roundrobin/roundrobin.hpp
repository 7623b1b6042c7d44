// Round robins: every team plays every other team.
#pragma once

#include <optional>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/team_versions.hpp"

namespace autoref::experiments {

struct RoundRobin : NamedTeams, ExperimentOf<RoundRobin> {
  static const Kind kKind;

  TeamVersions versions;  // of the teams
  int pairs = 1;          // pairs of legs per matchup, 1 to 9999

  std::vector<Key> keys() override;
  std::optional<VersionedTeams> versioned_teams() override;
  std::vector<ScheduledGame> games() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

}  // namespace autoref::experiments
