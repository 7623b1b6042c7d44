// The scores of scenes that share a situation and teams.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/results/game_row.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/paired_difference.hpp"
#include "game/loop/start_scene.hpp"

namespace autoref::experiments {

// A situation and the teams that play it: the values of a group of scenes.
struct SituationMatchup {
  std::string situation;
  std::string attackers;
  std::string defenders;
  auto operator<=>(const SituationMatchup&) const =
      default;  // NOLINT(modernize-use-nullptr): not a pointer
};

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

// The group of these rows. `is_proportion` is the group's.
SceneGroup scene_group(SituationMatchup matchup, bool is_proportion,
                       const std::vector<const GameRow*>& rows);

// The 95 % interval of the proportion of scenes that are `successes`. It is Wilson's interval with
// a reduced number of scenes, because the two legs of a pair share their start state and are
// correlated. The reduction is the design effect of clusters of two, at least 1. If no scene or
// every scene is a success, it is Clopper and Pearson's interval.
std::optional<Interval> scene_share_interval(int successes, std::size_t scenes,
                                             const DifferenceByPair& by_pair);

// The 95 % interval of the mean score. If every score is 0 or 1, it is the interval of a
// proportion, otherwise Student's interval over pairs.
std::optional<Interval> score_interval(const SceneGroup& group);

}  // namespace autoref::experiments
