#include "experiments/kinds/situations/scene_groups.hpp"

#include <map>

#include "experiments/results/game_row.hpp"
#include "experiments/statistics/paired_difference.hpp"

namespace autoref::experiments {
namespace {

bool are_comparable(const SceneGroup& one, const SceneGroup& other) {
  return one.matchup.situation == other.matchup.situation &&
         one.matchup.defenders == other.matchup.defenders;
}

}  // namespace

std::vector<SceneGroup> scene_groups(const Situations& situations, const RowsById& rows) {
  std::map<SituationMatchup, std::vector<const GameRow*>> by_matchup;
  for (const auto& [id, row] : rows)
    by_matchup[{row.values.front(), row.team_a, row.team_b}].push_back(&row);
  std::vector<SceneGroup> groups;
  for (const SituationMatchup& matchup : matchups_of(situations)) {
    const game::Scene& scene = situations.situations.at(matchup.situation).scene;
    groups.push_back(scene_group(matchup, scene.weights.is_proportion(), by_matchup[matchup]));
  }
  return groups;
}

std::vector<SceneDifference> scene_differences(const std::vector<SceneGroup>& groups) {
  std::vector<SceneDifference> differences;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      if (!are_comparable(groups[i], groups[j])) continue;
      differences.push_back({groups[i].matchup, groups[j].matchup.attackers,
                             paired_difference(groups[i].pair_scores, groups[j].pair_scores)});
    }
  }
  correct_by_holm(differences, &SceneDifference::difference);
  return differences;
}

}  // namespace autoref::experiments
