// Scores of situations, by situation and teams, and the differences between teams.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/situations/situations.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/scenes/scene_group.hpp"
#include "experiments/statistics/paired_difference.hpp"

namespace autoref::experiments {

// One group per situation and teams, in the order of matchups_of().
std::vector<SceneGroup> scene_groups(const Situations& situations, const RowsById& rows);

// The difference between two attacking teams in one situation against the same defenders: `team`
// minus `other`, over the pair numbers that both have. Both teams start from the same states with
// the same seeds.
struct SceneDifference {
  SituationMatchup matchup;  // the matchup of `team`
  std::string other;
  PairedDifference difference;
};

// One difference for every two attacking teams. The p values are corrected over all differences.
std::vector<SceneDifference> scene_differences(const std::vector<SceneGroup>& groups);

}  // namespace autoref::experiments
