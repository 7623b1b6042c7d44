// What the new team of a comparison does differently.
#include "experiments/analysis/play_differences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "experiments/schedule/schedule.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr auto kFromCorner = static_cast<std::size_t>(game::ChainStart::kCornerKick);

using Counts = game::PlayCounts;

const PlayDifference& named(const std::vector<PlayDifference>& differences,
                            const std::string& name) {
  const auto found =
      std::find_if(differences.begin(), differences.end(),
                   [&name](const PlayDifference& difference) { return difference.name == name; });
  if (found == differences.end()) throw std::out_of_range(name);
  return *found;
}

// The counts of a team in a game of these rows.
Counts& counts_of(RowsById& rows, const std::string& matchup, int pair, int leg, std::size_t team) {
  return rows[game_id(matchup, pair, leg)].record.counts[team];
}

TEST(PlayDifferences, AreMeansPerGameOfTeamsThatPlayEachOther) {
  RowsById rows;
  counts_of(rows, "new~old", 1, 1, 0).by_start[kFromCorner].chains = 2;
  counts_of(rows, "new~old", 1, 2, 0).by_start[kFromCorner].chains = 3;
  counts_of(rows, "new~old", 1, 1, 1).by_start[kFromCorner].chains = 6;
  counts_of(rows, "new~old", 1, 2, 1).possession_s = 60;
  const auto differences = play_differences({{"new~old", std::nullopt}}, {1}, rows);
  const PlayDifference& corners = named(differences, "chains from corner kicks");
  EXPECT_DOUBLE_EQ(corners.of_new, 2.5);
  EXPECT_DOUBLE_EQ(corners.of_old, 3);
  EXPECT_DOUBLE_EQ(corners.mean, -0.5);
  EXPECT_FALSE(corners.interval);
  EXPECT_DOUBLE_EQ(named(differences, "seconds of possession").mean, -30);
}

// Against common opponents, only the two teams' own counts matter.
TEST(PlayDifferences, AreMeansOverOpponents) {
  RowsById rows;
  for (const int leg : {1, 2}) {
    counts_of(rows, "new~old", 1, leg, 0).passes_tried = 8;
    counts_of(rows, "new~old", 1, leg, 1).passes_tried = 4;
    counts_of(rows, "new~x", 1, leg, 0).passes_tried = 2;
    counts_of(rows, "new~x", 1, leg, 1).passes_tried = 100;
    counts_of(rows, "old~x", 1, leg, 0).passes_tried = 12;
    counts_of(rows, "old~x", 1, leg, 1).passes_tried = 50;
  }
  const PlayDifference passes = named(
      play_differences({{"new~old", std::nullopt}, {"new~x", "old~x"}}, {1}, rows), "passes tried");
  EXPECT_DOUBLE_EQ(passes.of_new, 5);
  EXPECT_DOUBLE_EQ(passes.of_old, 8);
  EXPECT_DOUBLE_EQ(passes.mean, -3);
}

// Every count but the parts of the goal difference.
TEST(PlayDifferences, HaveEachCountOnce) {
  RowsById rows;
  for (const int leg : {1, 2}) rows[game_id("new~old", 1, leg)];
  std::vector<std::string> names;
  for (const auto& difference : play_differences({{"new~old", std::nullopt}}, {1}, rows))
    names.push_back(difference.name);
  const std::size_t plain = game::kChainStartCount + game::count_fields().size() - 3;
  EXPECT_EQ(names.size(), plain + 2 + game::kActionKindCount - 1);
  EXPECT_EQ(names[plain - 1], "duels won");
  EXPECT_EQ(names.back(), "worth of fouls");
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

std::vector<PlayDifference> after_games(int pairs, double fewer_shots, std::uint64_t seed) {
  RowsById rows;
  std::vector<int> numbers;
  RandomStream random(seed);
  for (int pair = 1; pair <= pairs; ++pair) {
    numbers.push_back(pair);
    for (const int leg : {1, 2}) {
      for (const std::size_t team : {0U, 1U}) {
        Counts& counts = counts_of(rows, "new~old", pair, leg, team);
        counts.shots = 20 + static_cast<int>(3 * random.normal());
        if (team == 0) counts.shots -= static_cast<int>(fewer_shots);
        counts.fouls = 10 + static_cast<int>(3 * random.normal());
        counts.by_start[kFromCorner].chains = team == 0 ? 0 : 5 + static_cast<int>(random.normal());
      }
    }
  }
  return play_differences({{"new~old", std::nullopt}}, numbers, rows);
}

TEST(PlayDifferences, NameTheMostCertainOneFirst) {
  const auto certain = certain_differences(after_games(30, 4, 1));
  ASSERT_EQ(certain.size(), 2U);
  EXPECT_EQ(certain[0].name, "chains from corner kicks");
  EXPECT_EQ(certain[1].name, "shots");
  EXPECT_LT(certain[1].interval->high, 0);
}

TEST(PlayDifferences, AreRarelyCertainBetweenEqualTeams) {
  int wrong = 0;  // anything but the corner kicks
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    wrong += certain_differences(after_games(20, 0, 100 + seed)).size() > 1 ? 1 : 0;
  EXPECT_LE(wrong, 5);
}

}  // namespace
}  // namespace autoref::experiments
