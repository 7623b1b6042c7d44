#include "experiments/schedule/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "experiments/kinds/gauntlet/gauntlet.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/results/shard.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

using Counts = std::map<std::string, int>;

int games_apart(const Counts& counts) {
  const auto by_count = [](const auto& one, const auto& other) {
    return one.second < other.second;
  };
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end(), by_count);
  return most->second - least->second;
}

using NamesOf = std::vector<std::string> (*)(const ScheduledGame&);

std::vector<std::string> teams_of(const ScheduledGame& game) { return {game.team_a, game.team_b}; }
std::vector<std::string> first_value_of(const ScheduledGame& game) { return {game.values[0]}; }
std::vector<std::string> second_value_of(const ScheduledGame& game) { return {game.values[1]}; }
std::vector<std::string> attackers_of(const ScheduledGame& game) { return {game.team_a}; }
std::vector<std::string> defenders_of(const ScheduledGame& game) { return {game.team_b}; }

// By how much the numbers of games with each name differ at most, in every beginning of the order.
int widest_spread(const std::vector<ScheduledGame>& games, NamesOf names_of) {
  Counts counts;
  for (const ScheduledGame& game : games) {
    for (const std::string& name : names_of(game)) counts[name] = 0;
  }
  int widest = 0;
  for (const ScheduledGame& game : games) {
    for (const std::string& name : names_of(game)) ++counts[name];
    widest = std::max(widest, games_apart(counts));
  }
  return widest;
}

std::vector<ScheduledGame> robin_games(int teams, int pairs = 3) {
  return small_roundrobin(std::vector<int>(static_cast<std::size_t>(teams), 6), pairs)
      .experiment()
      .games();
}

class RoundRobinOrder : public testing::TestWithParam<int> {};

// A pair, of two games, is what a round needs.
TEST_P(RoundRobinOrder, LetsNoTeamPlayASecondPairBeforeAllHavePlayedOne) {
  EXPECT_EQ(widest_spread(robin_games(GetParam()), teams_of), 2);
}

TEST_P(RoundRobinOrder, ContainsEveryMatchupOnce) {
  const auto teams = static_cast<std::size_t>(GetParam());
  const std::vector<std::size_t> order = round_robin_order(teams);
  EXPECT_EQ(order.size(), teams * (teams - 1) / 2);
  EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), order.size());
  EXPECT_EQ(*std::max_element(order.begin(), order.end()), order.size() - 1);
}

INSTANTIATE_TEST_SUITE_P(All, RoundRobinOrder, testing::Values(3, 4, 5, 6, 7, 8, 9, 21, 30));

TEST(RoundRobinOrderOfTwo, IsTheirMatchup) {
  EXPECT_EQ(round_robin_order(2), std::vector<std::size_t>{0});
}

Scenario sweep_of_two_factors() {
  Scenario scenario = small_sweep(2);
  auto& sweep = *scenario.as<Sweep>();
  sweep.factors = {{"b.robots", {}}, {"sim.vision.ball_noise_m", {}}};
  for (const int robots : {3, 4, 5, 6}) sweep.factors[0].values.emplace_back(robots);
  for (int i = 0; i < 6; ++i) sweep.factors[1].values.emplace_back(i / 1000.0);
  return scenario;
}

TEST(SweepOrder, PlaysEveryValueOfAFactorEquallyOften) {
  const std::vector<ScheduledGame> games = sweep_of_two_factors().experiment().games();
  EXPECT_EQ(games.size(), 96U);
  EXPECT_EQ(widest_spread(games, first_value_of), 2);
  EXPECT_EQ(widest_spread(games, second_value_of), 2);
}

TEST(CombinationsOrder, ContainsEveryCombinationOnce) {
  const std::vector<std::size_t> order = combinations_order({4, 6, 1, 10});
  EXPECT_EQ(order.size(), 240U);
  EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 240U);
  EXPECT_EQ(*std::max_element(order.begin(), order.end()), 239U);
}

TEST(CombinationsOrder, OfOneListIsThatOfTheList) {
  EXPECT_EQ(combinations_order({4}), (std::vector<std::size_t>{0, 1, 2, 3}));
}

Gauntlet gauntlet_of(int challengers, int teams) {
  Gauntlet gauntlet;
  for (int i = 0; i < challengers; ++i) gauntlet.challengers["c" + std::to_string(i)] = {};
  for (int i = 0; i < teams; ++i) gauntlet.teams["t" + std::to_string(i)] = {};
  gauntlet.pairs = 2;
  return gauntlet;
}

TEST(GauntletOrder, LetsChallengersAndTheFieldPlayEquallyOften) {
  const std::vector<ScheduledGame> games = Scenario{"", gauntlet_of(4, 6)}.experiment().games();
  EXPECT_EQ(widest_spread(games, attackers_of), 2);
  EXPECT_EQ(widest_spread(games, defenders_of), 2);
}

TEST(SituationsOrder, LetsEverybodyPlayEquallyOften) {
  Situations situations = situations_in(small_situations());
  const game::TeamSettings attackers = situations.attackers.begin()->second;
  const game::TeamSettings defenders = situations.defenders.begin()->second;
  for (const char* name : {"x", "y", "z"}) {
    situations.attackers[name] = attackers;
    situations.defenders[name] = defenders;
  }
  const std::vector<ScheduledGame> games = Scenario{"", situations}.experiment().games();
  EXPECT_EQ(widest_spread(games, first_value_of), 2);
  EXPECT_EQ(widest_spread(games, attackers_of), 2);
  EXPECT_EQ(widest_spread(games, defenders_of), 2);
}

TEST(PlayingOrder, KeepsTheLegsOfAPairTogether) {
  for (const Scenario& scenario : {sweep_of_two_factors(), small_roundrobin({6, 5, 4, 3, 2}, 2)}) {
    const std::vector<ScheduledGame> games = scenario.experiment().games();
    for (std::size_t i = 0; i < games.size(); i += 2) {
      EXPECT_EQ(games[i].id.substr(0, games[i].id.size() - 1) + "2", games[i + 1].id);
    }
  }
}

std::vector<ScheduledGame> games_of_shard(const std::vector<ScheduledGame>& games, int number,
                                          int of) {
  std::vector<ScheduledGame> chosen;
  for (const ScheduledGame& game : games) {
    if (ShardIndex{number, of}.has(game.unit, game.variants)) chosen.push_back(game);
  }
  return chosen;
}

// A team plays 14 games of each pair number. If a shard always got the same places of the order, it
// would get the same matchups for all 20, and the difference would be 20 times as large.
TEST(PlayingOrder, GivesEveryShardAboutAsManyGamesOfEveryTeam) {
  const std::vector<ScheduledGame> games = robin_games(8, 20);
  for (const int of : {2, 4, 5}) {
    for (int number = 0; number < of; ++number) {
      const std::vector<ScheduledGame> its = games_of_shard(games, number, of);
      EXPECT_LT(widest_spread(its, teams_of), 14) << number << "/" << of;
    }
  }
}

TEST(PlayingOrder, GivesEveryShardAllValuesOfAFactor) {
  const std::vector<ScheduledGame> games = small_sweep(40).experiment().games();
  for (const int number : {0, 1}) {
    EXPECT_EQ(widest_spread(games_of_shard(games, number, 2), first_value_of), 2);
  }
}

}  // namespace
}  // namespace autoref::experiments
