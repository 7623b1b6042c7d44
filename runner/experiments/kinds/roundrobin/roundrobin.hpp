// Round robins: every team plays every other team.
#pragma once

#include <vector>

#include "runner/experiments/kinds/experiment.hpp"
#include "runner/experiments/named_teams.hpp"

namespace autoref::runner {

struct RoundRobin : NamedTeams, ExperimentOf<RoundRobin> {
  static const Kind kKind;

  int pairs = 1;  // pairs of legs per matchup, 1 to 9999

  std::vector<Key> keys() override;
  std::vector<ScheduledGame> games() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

// Every pairing of two different teams once, ordered by name (compared as bytes).
std::vector<Matchup> matchups_of(const RoundRobin& robin);

}  // namespace autoref::runner
