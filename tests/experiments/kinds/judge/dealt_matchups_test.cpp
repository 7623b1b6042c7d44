#include "experiments/kinds/judge/judge_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace autoref::experiments {
namespace {

using Names = std::vector<std::string>;

Names teams(std::size_t count) {
  const Names all = {"a", "b", "c", "d", "e", "f", "g"};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

// The largest difference between two numbers of games.
int spread(const std::map<std::string, int>& counts) {
  const auto [least, most] = std::minmax_element(
      counts.begin(), counts.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  return most->second - least->second;
}

std::string pair_of(std::array<std::string, 2> matchup) {
  std::sort(matchup.begin(), matchup.end());
  return matchup[0] + matchup[1];
}

class Deals : public testing::TestWithParam<std::size_t> {
 protected:
  static std::map<std::string, int> no_games_of_pairs() {
    std::map<std::string, int> counts;
    for (const std::string& one : teams(GetParam())) {
      for (const std::string& other : teams(GetParam())) counts[pair_of({one, other})] = 0;
    }
    return counts;
  }
};

TEST_P(Deals, GiveEveryPairEquallyManyMatchupsAfterAnyNumber) {
  std::map<std::string, int> counts = no_games_of_pairs();
  const std::size_t pairs = GetParam() * (GetParam() + 1) / 2;
  ASSERT_EQ(counts.size(), pairs);
  for (const auto& matchup : dealt_matchups(teams(GetParam()), 7, 3 * pairs)) {
    ++counts[pair_of(matchup)];
    ASSERT_LE(spread(counts), 1);
  }
  EXPECT_EQ(counts.begin()->second, 3);
}

// A matchup of a team with itself counts once.
TEST_P(Deals, LetEveryTeamPlayEquallyOftenAfterAnyNumber) {
  std::map<std::string, int> counts;
  for (const std::string& team : teams(GetParam())) counts[team] = 0;
  for (const auto& matchup : dealt_matchups(teams(GetParam()), 7, 60)) {
    ++counts[matchup[0]];
    if (matchup[1] != matchup[0]) ++counts[matchup[1]];
    ASSERT_LE(spread(counts), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Teams, Deals, testing::Values(1, 2, 5, 6, 7));

TEST(DealtMatchups, SwapTheTeamsOfAPairFromCycleToCycle) {
  const auto dealt = dealt_matchups(teams(3), 5, 12);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto again = std::find_if(dealt.begin() + 6, dealt.end(), [&](const auto& later) {
      return pair_of(later) == pair_of(dealt[i]);
    });
    EXPECT_EQ((*again)[0], dealt[i][1]);
  }
}

TEST(DealtMatchups, DependOnTheSeedAlone) {
  EXPECT_EQ(dealt_matchups(teams(7), 1, 28), dealt_matchups(teams(7), 1, 28));
  EXPECT_NE(dealt_matchups(teams(7), 1, 28), dealt_matchups(teams(7), 2, 28));
}

TEST(DealtMatchups, StayTheSameIfMoreAreDealt) {
  const auto few = dealt_matchups(teams(7), 1, 9);
  const auto many = dealt_matchups(teams(7), 1, 50);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

// Expected values from this program: games that were played keep their teams.
TEST(DealtMatchups, AreTheSameOnEveryMachine) {
  const auto dealt = dealt_matchups(teams(3), 2016, 3);
  const std::vector<std::array<std::string, 2>> expected = {{"c", "c"}, {"a", "b"}, {"b", "c"}};
  EXPECT_EQ(dealt, expected);
}

}  // namespace
}  // namespace autoref::experiments
