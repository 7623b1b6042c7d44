// Situations: short scenes that compare teams in attack, each against the same defending teams.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/scenes/scene_group.hpp"
#include "experiments/scenes/situation.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

// Every attacking team, as team a, plays every situation against every defending team. A team name
// can be in both lists.
struct Situations : ExperimentOf<Situations> {
  static const Kind kKind;

  game::GameSettings base;  // its teams, seed, a_plays and first_kickoff are ignored
  Teams attackers;
  Teams defenders;
  SituationsByName situations;
  // Number of scenes drawn for each situation, 1 to 9999. Each scene is played in two legs.
  int pairs = 1;
  std::uint64_t seed = 1;  // master seed

  std::vector<Key> keys() override;
  // The games in playing order. Each scene number is played with all situations and teams before
  // the next one, and its two legs are adjacent. The second leg has the same start state, rotated
  // to the other side. A game depends only on its situation, teams, pair and leg; all teams get the
  // same start states and seeds. Ids look like "corner+cobalt~possession-p0007-2". In addition to
  // the errors of Experiment::games(), throws std::invalid_argument if a start state cannot be
  // drawn.
  std::vector<ScheduledGame> games() const override;
  RowKind row_kind() const override { return RowKind::kScene; }
  std::vector<std::string> value_columns() const override { return {"situation"}; }
  ExperimentResults results(const RowsById& rows) const override;
};

// All matchups of the experiment, in order of their names.
std::vector<SituationMatchup> matchups_of(const Situations& situations);

}  // namespace autoref::experiments
