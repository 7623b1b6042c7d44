#include "experiments/kinds/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {
namespace {

Sweep handicap_sweep(std::vector<game::SettingValue> values, int pairs) {
  Sweep sweep;
  sweep.factors = {{"b.handicap", std::move(values)}};
  sweep.pairs = pairs;
  sweep.seed = 2014;
  return sweep;
}

std::map<std::string, std::uint64_t> hashes_of(const Sweep& sweep) {
  std::map<std::string, std::uint64_t> hashes;
  for (const ScheduledGame& game : sweep.games()) {
    hashes[game.id] = game::configuration_hash(game.settings.combined());
  }
  return hashes;
}

TEST(Schedule, NamesGamesByValuePairAndLeg) {
  const std::vector<ScheduledGame> games = handicap_sweep({1.0, 0.8}, 7).games();
  ASSERT_EQ(games.size(), 28U);
  EXPECT_EQ(games.front().id, "b.handicap=1.0-p0001-1");
  EXPECT_EQ(games.back().id, "b.handicap=0.8-p0007-2");
  EXPECT_EQ(games.back().settings.combined().b.speed_factor, 0.8);
}

TEST(Schedule, PlaysTheLegsBackToBackAndPairByPairOverAllValues) {
  const std::vector<ScheduledGame> games = handicap_sweep({1.0, 0.8}, 2).games();
  std::vector<std::string> ids;
  for (const ScheduledGame& game : games) ids.push_back(game.id.substr(game.id.find('=') + 1));
  const std::vector<std::string> expected = {"1.0-p0001-1", "1.0-p0001-2", "0.8-p0001-1",
                                             "0.8-p0001-2", "1.0-p0002-1", "1.0-p0002-2",
                                             "0.8-p0002-1", "0.8-p0002-2"};
  EXPECT_EQ(ids, expected);
}

TEST(Schedule, GivesEachTeamEachSideAndTheFirstKickOffEquallyOften) {
  std::map<std::pair<Side, bool>, int> counts;  // side of team a, whether a kicks off
  for (const ScheduledGame& game : handicap_sweep({1.0}, 10).games()) {
    const referee::Match match = game.settings.combined().match;
    EXPECT_EQ(match.a_plays, game.leg == 1 ? Side::kWest : Side::kEast);
    ++counts[{match.a_plays, match.a_plays == match.first_kickoff}];
  }
  EXPECT_EQ(counts.size(), 4U);
  for (const auto& [what, count] : counts) EXPECT_EQ(count, 5);
}

TEST(Schedule, KeepsAllGamesWhenValuesOrPairsAreAdded) {
  const auto few = hashes_of(handicap_sweep({1.0, 0.8}, 2));
  const auto many = hashes_of(handicap_sweep({0.9, 0.8, 1.0}, 5));
  for (const auto& [id, hash] : few) EXPECT_EQ(many.at(id), hash) << id;
}

TEST(Schedule, GivesEveryLegItsOwnSeedIndependentOfTheValue) {
  std::map<std::pair<int, int>, std::set<std::uint64_t>> by_leg;
  std::set<std::uint64_t> all;
  for (const ScheduledGame& game : handicap_sweep({1.0, 0.8}, 50).games()) {
    by_leg[{game.pair, game.leg}].insert(game.settings.combined().seed);
    all.insert(game.settings.combined().seed);
  }
  EXPECT_EQ(all.size(), 100U);
  for (const auto& [leg, seeds] : by_leg) EXPECT_EQ(seeds.size(), 1U);
}

TEST(Schedule, CombinesAllValuesOfSeveralFactors) {
  Sweep sweep = handicap_sweep({1.0, 0.8}, 1);
  sweep.factors.push_back({"a.robots", {6, 5, 4}});
  const std::vector<ScheduledGame> games = sweep.games();
  ASSERT_EQ(games.size(), 12U);
  std::map<std::string, int> robots;
  for (const ScheduledGame& game : games) robots[game.id] = game.settings.combined().a.robots;
  EXPECT_EQ(robots.size(), 12U);
  EXPECT_EQ(robots.at("b.handicap=1.0+a.robots=5-p0001-1"), 5);
}

TEST(Schedule, GivesALegTheSameSeedInAllCombinationsOfTwoFactorsAndInASweepOverOne) {
  std::map<std::string, std::set<std::uint64_t>> by_leg;  // by the end of the id, "p0001-1"
  const auto add = [&by_leg](const Sweep& sweep) {
    for (const ScheduledGame& game : sweep.games())
      by_leg[game.id.substr(game.id.size() - 7)].insert(game.settings.combined().seed);
  };
  Sweep grid = handicap_sweep({1.0}, 3);
  add(grid);
  grid.factors = {{"a.robots", {6, 5, 4}}, {"b.robots", {6, 5}}};
  add(grid);
  EXPECT_EQ(by_leg.size(), 6U);
  for (const auto& [leg, seeds] : by_leg) EXPECT_EQ(seeds.size(), 1U) << leg;
}

TEST(Schedule, SweepsATeamsParameter) {
  Sweep sweep;
  sweep.factors = {{"a.params.shot_mps", {6.5, 4.0}}};
  const std::vector<ScheduledGame> games = sweep.games();
  ASSERT_EQ(games.size(), 4U);
  EXPECT_EQ(games[2].id, "a.params.shot_mps=4.0-p0001-1");
  EXPECT_EQ(games[2].settings.combined().a.params.at("shot_mps"), 4);
  EXPECT_TRUE(games[2].settings.combined().b.params.empty());
}

TEST(SeedOf, StaysBelowTwoToThe53AndDependsOnTheMasterSeed) {
  EXPECT_LT(seed_of(1, 1, 1), std::uint64_t{1} << 53);
  EXPECT_NE(seed_of(1, 1, 1), seed_of(2, 1, 1));
  EXPECT_NE(seed_of(1, 1, 2), seed_of(1, 2, 1));
}

}  // namespace
}  // namespace autoref::experiments
