#include "experiments/analysis/team_differences.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace autoref::experiments {
namespace {

// A matchup with these goal differences of team a, for pairs 1, 2, ...
Group matchup_of(const std::string& a, const std::string& b, const std::vector<double>& leads) {
  Group group;
  group.values = {a, b};
  int pair = 0;
  for (const double lead : leads) group.pair_differences[++pair] = lead;
  return group;
}

TEST(TeamDifferences, CompareChallengersOverTheWholeField) {
  const std::vector<Group> matchups = {
      matchup_of("fast", "one", {3, 1, 2}), matchup_of("fast", "two", {1, 1, 0}),
      matchup_of("mine", "one", {1, 1, 1}), matchup_of("mine", "two", {0, -1, 0})};
  const std::vector<TeamDifference> differences = team_differences(matchups, {"fast", "mine"});
  ASSERT_EQ(differences.size(), 1U);
  EXPECT_EQ(differences[0].team, "fast");
  EXPECT_EQ(differences[0].other, "mine");
  EXPECT_EQ(differences[0].opponents, 2);
  // (3 + 1) / 2 - (1 + 0) / 2 = 1.5, then 1 and 0.5.
  EXPECT_EQ(differences[0].difference.pairs, 3U);
  EXPECT_DOUBLE_EQ(*differences[0].difference.mean, 1);
  EXPECT_TRUE(differences[0].difference.interval);
}

// The teams of a round robin are team a in some matchups and team b in others.
TEST(TeamDifferences, OfARoundRobinAreFromTheTeamsPointOfView) {
  const std::vector<Group> matchups = {matchup_of("a", "b", {5, 5}), matchup_of("a", "c", {4, 2}),
                                       matchup_of("b", "c", {1, 2})};
  const std::vector<TeamDifference> differences = team_differences(matchups, {"a", "b", "c"});
  ASSERT_EQ(differences.size(), 3U);
  EXPECT_DOUBLE_EQ(*differences[0].difference.mean, 3 - 1.5);    // a and b, against c
  EXPECT_DOUBLE_EQ(*differences[1].difference.mean, 5 + 1.5);    // a and c, against b
  EXPECT_DOUBLE_EQ(*differences[2].difference.mean, -5 - (-3));  // b and c, against a
  EXPECT_EQ(differences[2].opponents, 1);
}

TEST(TeamDifferences, LeaveOutPairsThatLackAGame) {
  std::vector<Group> matchups = {
      matchup_of("fast", "one", {3, 1, 2}), matchup_of("fast", "two", {1, 1, 0}),
      matchup_of("mine", "one", {1, 1, 1}), matchup_of("mine", "two", {0, -1, 0})};
  matchups[1].pair_differences.erase(2);
  const std::vector<TeamDifference> differences = team_differences(matchups, {"fast", "mine"});
  EXPECT_EQ(differences.at(0).difference.pairs, 2U);
  EXPECT_DOUBLE_EQ(*differences.at(0).difference.mean, 1);  // 1.5 and 0.5
}

TEST(TeamDifferences, CorrectOverAllTeams) {
  const std::vector<Group> matchups = {matchup_of("x", "field", {3, 1, 2, 2}),
                                       matchup_of("y", "field", {1, 0, 1, 0}),
                                       matchup_of("z", "field", {0, 0, 1, 1})};
  const std::vector<TeamDifference> differences = team_differences(matchups, {"x", "y", "z"});
  ASSERT_EQ(differences.size(), 3U);
  double smallest = 1;
  for (const TeamDifference& one : differences) smallest = std::min(smallest, *one.difference.p);
  EXPECT_DOUBLE_EQ(*differences[0].difference.p, smallest);
  EXPECT_DOUBLE_EQ(*differences[0].difference.p_holm, 3 * smallest);
}

TEST(TeamDifferences, NeedACommonOpponent) {
  EXPECT_TRUE(team_differences({matchup_of("a", "b", {1, 2})}, {"a", "b"}).empty());
  EXPECT_TRUE(team_differences_table({}).empty());
}

TEST(TeamDifferencesTable, CallsEqualPairsEqualAndASinglePairTooFew) {
  const auto text_of_leads = [](const std::vector<double>& one, const std::vector<double>& other) {
    return io::text_of(team_differences_table(team_differences(
        {matchup_of("x", "field", one), matchup_of("y", "field", other)}, {"x", "y"})));
  };
  EXPECT_NE(text_of_leads({2, 3}, {1, 2}).find("+1.00 (all pairs equal)"), std::string::npos);
  EXPECT_NE(text_of_leads({2}, {1}).find("+1.00 (too few games)"), std::string::npos);
  EXPECT_NE(text_of_leads({2, 3}, {1, 1}).find("+1.50 ["), std::string::npos);
}

TEST(TeamDifferencesTable, RefersToTheCsvIfThereAreManyTeams) {
  std::vector<Group> matchups;
  std::vector<std::string> teams;
  for (int i = 0; i < 7; ++i) {
    teams.push_back("team" + std::to_string(i));
    matchups.push_back(matchup_of(teams.back(), "field", {1.0 * i, 2.0 * i}));
  }
  const std::vector<TeamDifference> differences = team_differences(matchups, teams);
  EXPECT_EQ(differences.size(), 21U);
  EXPECT_NE(io::text_of(team_differences_table(differences)).find("differences.csv"),
            std::string::npos);
  EXPECT_NE(team_differences_csv(differences).find("\nteam0,team1,1,2,"), std::string::npos);
}

}  // namespace
}  // namespace autoref::experiments
