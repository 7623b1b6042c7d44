// Sweeps: every combination of the values of some settings.
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/kinds/experiment.hpp"

namespace autoref::experiments {

// Plays every combination of the factors' values for `pairs` pairs of legs.
struct Sweep : ExperimentOf<Sweep> {
  static const Kind kKind;

  game::GameSettings base;  // its seed, a_plays and first_kickoff are set by the schedule
  std::vector<Factor> factors;
  int pairs = 1;           // pairs of legs per combination, 1 to 9999
  std::uint64_t seed = 1;  // master seed of the sweep

  std::vector<Key> keys() override;
  std::vector<Factor> varied_settings() const override { return factors; }
  // The games in playing order. The two legs of a pair are adjacent. All combinations play a pair
  // number before the next number begins, in combinations_order() (schedule.hpp), so an interrupted
  // run is balanced. A game depends only on its own values, pair and leg, so adding values or pairs
  // changes no other game.
  std::vector<ScheduledGame> games() const override;
  std::vector<std::string> value_columns() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

}  // namespace autoref::experiments
