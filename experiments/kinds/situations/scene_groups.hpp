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

// The results of all scenes of a situation between two teams. Void scenes count only in
// `void_scenes`.
struct SceneGroup {
  SituationMatchup matchup;
  bool is_proportion = true;   // whether every score is 0 or 1
  std::vector<double> scores;  // the score of each scene
  // Mean score over the two legs, by pair number; only pairs without a void leg.
  DifferenceByPair pair_scores;
  DifferenceByPair pair_goals;  // like pair_scores, but of 1 if the attackers scored, otherwise 0
  int void_scenes = 0;
  int goals = 0;                 // scenes in which the attackers scored
  int conceded = 0;              // scenes in which the defenders scored
  int kept = 0;                  // scenes after which the attackers had the ball
  std::vector<double> gained_m;  // the distance gained in each scene
  std::array<int, game::kSceneEndCount> ends{};
};

// One group per situation and teams, in the order of matchups_of().
std::vector<SceneGroup> scene_groups(const Situations& situations, const RowsById& rows);

// The 95 % interval of the proportion of scenes that are `successes`. It is Wilson's interval with
// a reduced number of scenes, because the two legs of a pair share their start state and are
// correlated. The reduction is the design effect of clusters of two, at least 1. If no scene or
// every scene is a success, it is Clopper and Pearson's interval.
std::optional<Interval> scene_share_interval(int successes, std::size_t scenes,
                                             const DifferenceByPair& by_pair);

// The 95 % interval of the mean score. If every score is 0 or 1, it is the interval of a
// proportion, otherwise Student's interval over pairs.
std::optional<Interval> score_interval(const SceneGroup& group);

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
