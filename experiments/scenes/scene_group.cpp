#include "experiments/scenes/scene_group.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

struct SceneLegs {
  std::vector<double> scores;
  std::vector<double> goals;
};

void add_scene(SceneGroup& group, std::map<int, SceneLegs>& legs, const GameRow& row) {
  if (is_void(row.record) || !row.record.scene) {
    ++group.void_scenes;
    return;
  }
  const game::SceneRecord& scene = *row.record.scene;
  const bool has_scored = row.record.goals_a > 0;
  group.scores.push_back(scene.score);
  group.gained_m.push_back(scene.gained_m);
  group.goals += has_scored ? 1 : 0;
  group.conceded += row.record.goals_b > 0 ? 1 : 0;
  group.kept += scene.ball_kept ? 1 : 0;
  ++group.ends[static_cast<std::size_t>(scene.ended_by)];
  SceneLegs& pair = legs[row.pair];
  pair.scores.push_back(scene.score);
  pair.goals.push_back(has_scored ? 1 : 0);
}

void take_pairs(SceneGroup& group, const std::map<int, SceneLegs>& legs) {
  for (const auto& [pair, both] : legs) {
    if (both.scores.size() != 2) continue;
    group.pair_scores[pair] = mean(both.scores);
    group.pair_goals[pair] = mean(both.goals);
  }
}

}  // namespace

SceneGroup scene_group(SituationMatchup matchup, bool is_proportion,
                       const std::vector<const GameRow*>& rows) {
  SceneGroup group;
  group.matchup = std::move(matchup);
  group.is_proportion = is_proportion;
  std::map<int, SceneLegs> legs;
  for (const GameRow* row : rows) add_scene(group, legs, *row);
  take_pairs(group, legs);
  return group;
}

std::optional<Interval> scene_share_interval(int successes, std::size_t scenes,
                                             const DifferenceByPair& by_pair) {
  const auto n = static_cast<double>(scenes);
  if (successes == 0 || successes == static_cast<int>(scenes))
    return proportion_interval(successes, static_cast<int>(scenes));
  const double share = successes / n;
  const double deviation = standard_deviation(values_of(by_pair)).value_or(0);
  const double design_effect = std::max(1.0, 2 * deviation * deviation / (share * (1 - share)));
  return wilson_interval(successes / design_effect, n / design_effect);
}

std::optional<Interval> score_interval(const SceneGroup& group) {
  if (!group.is_proportion) return mean_interval(values_of(group.pair_scores));
  const auto successes =
      static_cast<int>(std::count(group.scores.begin(), group.scores.end(), 1.0));
  return scene_share_interval(successes, group.scores.size(), group.pair_scores);
}

}  // namespace autoref::experiments
