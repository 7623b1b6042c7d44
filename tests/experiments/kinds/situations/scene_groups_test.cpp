#include "experiments/kinds/situations/scene_groups.hpp"

#include <gtest/gtest.h>

#include "experiments/statistics/interval.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"

namespace autoref::experiments {
namespace {

GameRow scene_row(const std::string& team, int pair, int leg, double score) {
  GameRow row;
  row.game_id = team + std::to_string(pair) + std::to_string(leg);
  row.pair = pair;
  row.leg = leg;
  row.values = {"goal"};
  row.team_a = team;
  row.team_b = "still";
  row.record.goals_a = score > 0 ? 1 : 0;
  row.record.scene = game::SceneRecord{.score = score};
  return row;
}

// `one` scores in both legs of the first pair, `two` never.
RowsById scene_rows() {
  RowsById rows;
  for (const int pair : {1, 2, 3}) {
    for (const int leg : {1, 2}) {
      const double score = pair == 1 ? 1 : 0;
      for (const GameRow& row :
           {scene_row("one", pair, leg, score), scene_row("two", pair, leg, 0)})
        rows[row.game_id] = row;
    }
  }
  return rows;
}

std::vector<SceneGroup> groups_of_rows(const RowsById& rows) {
  return scene_groups(situations_in(small_situations()), rows);
}

TEST(SceneGroups, CountScenesAndAverageOverLegs) {
  const std::vector<SceneGroup> groups = groups_of_rows(scene_rows());
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[0].matchup, (SituationMatchup{"goal", "one", "still"}));
  EXPECT_EQ(groups[0].scores.size(), 6U);
  EXPECT_EQ(groups[0].goals, 2);
  EXPECT_EQ(groups[0].pair_scores, (DifferenceByPair{{1, 1}, {2, 0}, {3, 0}}));
  EXPECT_EQ(groups[1].goals, 0);
  EXPECT_TRUE(groups[2].scores.empty());
}

TEST(SceneGroups, LeaveOutVoidScenesAndTheirPairs) {
  RowsById rows = scene_rows();
  rows.begin()->second.record.status = game::Status::kVoid;
  const SceneGroup group = groups_of_rows(rows).front();
  EXPECT_EQ(group.void_scenes, 1);
  EXPECT_EQ(group.scores.size(), 5U);
  EXPECT_FALSE(group.pair_scores.contains(1));
}

// Both legs of a pair always agree here, so there are only half as many independent scenes.
TEST(SceneShareInterval, CountsLegsThatAgreeAsOneScene) {
  DifferenceByPair pairs;
  for (int pair = 1; pair <= 100; ++pair) pairs[pair] = pair <= 30 ? 1 : 0;
  const std::optional<Interval> interval = scene_share_interval(60, 200, pairs);
  const std::optional<Interval> of_pairs = wilson_interval(30, 100);
  EXPECT_NEAR(interval->low, of_pairs->low, 0.002);
  EXPECT_NEAR(interval->high, of_pairs->high, 0.002);
}

TEST(SceneShareInterval, IsWilsonsIfLegsAreIndependent) {
  DifferenceByPair pairs;
  for (int pair = 1; pair <= 100; ++pair) pairs[pair] = pair % 4 == 0 ? 1 : pair % 4 == 1 ? 0 : 0.5;
  EXPECT_NEAR(scene_share_interval(100, 200, pairs)->low, wilson_interval(100, 200)->low, 0.002);
}

TEST(SceneDifferences, ComparePairsOfTheSameNumber) {
  const std::vector<SceneDifference> differences = scene_differences(groups_of_rows(scene_rows()));
  ASSERT_EQ(differences.size(), 2U);
  EXPECT_EQ(differences[0].matchup.attackers, "one");
  EXPECT_EQ(differences[0].other, "two");
  EXPECT_EQ(differences[0].difference.pairs, 3U);
  EXPECT_NEAR(*differences[0].difference.mean, 1.0 / 3, 1e-12);
  EXPECT_FALSE(differences[1].difference.mean);
}

}  // namespace
}  // namespace autoref::experiments
