// Scores of situations, by situation and teams.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/kinds/situations/situations.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"

namespace autoref::experiments {

// The scenes of a situation between two teams. Void scenes count only in `void_scenes`.
struct SceneGroup {
  SituationMatchup matchup;
  bool is_proportion = true;     // every score is 0 or 1
  std::vector<double> scores;    // per scene
  DifferenceByPair pair_scores;  // by pair number: mean over the two legs if both count
  DifferenceByPair pair_goals;   // the same for whether the attackers scored
  int void_scenes = 0;
  int goals = 0;                 // scenes in which the attackers scored
  int conceded = 0;              // scenes in which the defenders scored
  int kept = 0;                  // scenes after which the attackers had the ball
  std::vector<double> gained_m;  // per scene
  std::array<int, game::kSceneEndCount> ends{};
};

// One group per situation and teams, in the order of matchups_of().
std::vector<SceneGroup> scene_groups(const Situations& situations, const RowsById& rows);

// The interval of a proportion of `successes` scenes. This is Wilson's interval with a reduced
// number of scenes, because the two legs of a pair share their start state and are correlated (the
// design effect of clusters of two, at least 1). With no successes or only successes, it is Clopper
// and Pearson's.
std::optional<Interval> scene_share_interval(int successes, std::size_t scenes,
                                             const DifferenceByPair& by_pair);

// The mean score's interval: that of a proportion if every score is 0 or 1, otherwise Student's
// interval over pairs.
std::optional<Interval> score_interval(const SceneGroup& group);

// Two attacking teams in one situation against the same defenders: `team` minus `other`, over the
// pair numbers that both have. Both started from the same states with the same seeds.
struct SceneDifference {
  SituationMatchup matchup;  // of `team`
  std::string other;
  PairedDifference difference;
};

// One difference for every two teams, with p values corrected over all of them.
std::vector<SceneDifference> scene_differences(const std::vector<SceneGroup>& groups);

}  // namespace autoref::experiments
