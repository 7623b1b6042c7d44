// Round robins: every team plays every other team.
#pragma once

#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

struct RoundRobin : NamedTeams, ExperimentOf<RoundRobin> {
  static const Kind kKind;

  int pairs = 1;  // pairs of legs per matchup, 1 to 9999

  std::vector<Key> keys() override;
  std::vector<ScheduledGame> games() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

}  // namespace autoref::experiments
