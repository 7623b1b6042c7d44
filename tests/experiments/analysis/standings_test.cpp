#include "experiments/analysis/standings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

struct Score {
  int a = 0;
  int b = 0;
  game::EndReason end = game::EndReason::kTime;
};

// The scores of two teams in the legs of their only pair of games.
struct Encounter {
  const char* team_a;
  const char* team_b;
  std::vector<Score> legs;
};

RoundRobin robin_with(const std::vector<Encounter>& encounters) {
  RoundRobin robin;
  for (const Encounter& encounter : encounters) {
    robin.teams[encounter.team_a];
    robin.teams[encounter.team_b];
  }
  return robin;
}

GameRow row_of(const Encounter& encounter, std::size_t leg) {
  const Score& score = encounter.legs[leg];
  GameRow row;
  game::GameRecord& record = row.record;
  record.goals_a = score.a;
  record.goals_b = score.b;
  record.end_reason = score.end;
  if (score.end == game::EndReason::kVoid) record.status = game::Status::kVoid;
  if (score.end == game::EndReason::kShootout) record.shootout = {{2, 3}};
  row.pair = 1;
  row.leg = static_cast<int>(leg) + 1;
  row.team_a = encounter.team_a;
  row.team_b = encounter.team_b;
  return row;
}

std::vector<Group> matchups_in(const std::vector<Encounter>& encounters) {
  RowsById rows;
  for (const Encounter& encounter : encounters) {
    for (std::size_t leg = 0; leg < encounter.legs.size(); ++leg)
      rows[fmt::format("game {:03}", rows.size())] = row_of(encounter, leg);
  }
  return grouped(matchups_among(robin_with(encounters).teams), rows);
}

std::vector<Standing> standings_in(const std::vector<Encounter>& encounters) {
  return standings_of(matchups_in(encounters));
}

// Bold beats calm 2:0 and 1:0, draws 1:1 with and loses 0:1 to zone; calm and zone draw 0:0 twice.
const std::vector<Encounter> kThreeTeams = {{"bold", "calm", {{2, 0}, {1, 0}}},
                                            {"bold", "zone", {{1, 1}, {0, 1}}},
                                            {"calm", "zone", {{0, 0}, {0, 0}}}};

TEST(Standings, GivesThreePointsForAWinAndOneForADraw) {
  const std::vector<Standing> standings = standings_in(kThreeTeams);
  ASSERT_EQ(standings.size(), 3U);
  EXPECT_EQ(standings[0].team, "bold");
  EXPECT_EQ(standings[0].points(), 7);
  EXPECT_EQ(standings[1].team, "zone");
  EXPECT_EQ(standings[1].points(), 6);
  EXPECT_EQ(standings[2].team, "calm");
  EXPECT_EQ(standings[2].points(), 2);
}

TEST(Standings, CountsGoalsForAndAgainstEachTeam) {
  const Standing bold = standings_in(kThreeTeams)[0];
  EXPECT_EQ(bold.goals_for, 4);
  EXPECT_EQ(bold.goals_against, 2);
  EXPECT_EQ(bold.pair_differences, (std::vector<double>{1.5, -0.5}));
  const Standing zone = standings_in(kThreeTeams)[1];
  EXPECT_EQ(zone.differences, (std::vector<double>{0, 1, 0, 0}));
  EXPECT_EQ(zone.pair_differences, (std::vector<double>{0.5, 0}));
}

TEST(Standings, RanksEqualPointsByGoalDifferenceThenByName) {
  const std::vector<Standing> standings =
      standings_in({{"b", "d", {{1, 0}}}, {"c", "d", {{3, 0}}}, {"a", "d", {{1, 0}}}});
  ASSERT_EQ(standings.size(), 4U);
  EXPECT_EQ(standings[0].team, "c");
  EXPECT_EQ(standings[1].team, "a");
  EXPECT_EQ(standings[2].team, "b");
}

TEST(Standings, LeavesVoidGamesAndTheirPairsOut) {
  const std::vector<Standing> standings =
      standings_in({{"a", "b", {{3, 1}, {9, 0, game::EndReason::kVoid}}}});
  EXPECT_EQ(standings[0].games(), 1);
  EXPECT_EQ(standings[0].void_games, 1);
  EXPECT_EQ(standings[1].void_games, 1);
  EXPECT_TRUE(standings[0].pair_differences.empty());
}

TEST(Standings, CountsAForfeitAsALossWhateverTheScore) {
  const std::vector<Standing> standings =
      standings_in({{"a", "b", {{3, 0, game::EndReason::kForfeitA}}}});
  EXPECT_EQ(standings[0].team, "b");
  EXPECT_EQ(standings[0].points(), 3);
}

TEST(Standings, CountsAShootOutWinAsAWin) {
  const std::vector<Group> matchups =
      matchups_in({{"a", "b", {{1, 1, game::EndReason::kShootout}}}});
  EXPECT_EQ(matchups[0].wins_b, 1);
  EXPECT_EQ(matchups[0].draws, 0);
}

TEST(StandingsReport, HasARowPerMatchupWithItsResults) {
  EXPECT_EQ(matchups_csv(matchups_in(kThreeTeams)),
            "team_a,team_b,games,void_games,mean_a,sd_a,mean_b,sd_b,mean_diff,sd_diff,pairs,"
            "diff_low95,diff_high95,"
            "wins_a,draws,wins_b,wins_a_share,wins_a_low95,wins_a_high95,draws_share,draws_low95,"
            "draws_high95,wins_b_share,wins_b_low95,wins_b_high95\n"
            "bold,calm,2,0,1.5000,0.7071,0.0000,0.0000,1.5000,0.7071,1,,,"
            "2,0,0,1.0000,0.1581,1.0000,0.0000,0.0000,0.8419,0.0000,0.0000,0.8419\n"
            "bold,zone,2,0,0.5000,0.7071,1.0000,0.0000,-0.5000,0.7071,1,,,"
            "0,1,1,0.0000,0.0000,0.8419,0.5000,0.0945,0.9055,0.5000,0.0945,0.9055\n"
            "calm,zone,2,0,0.0000,0.0000,0.0000,0.0000,0.0000,0.0000,1,,,"
            "0,2,0,0.0000,0.0000,0.8419,1.0000,0.1581,1.0000,0.0000,0.0000,0.8419\n");
}

// All three teams have met twice, so a team's goal rating is the sum of its differences divided by
// 3 * 2: (3 - 1) / 6 for bold. Bradley-Terry ratings: computed as in
// tests/experiments/statistics/strength_profile_test.cpp.
// bold's pairs are 1.5 and -0.5: mean 0.5, t(0.975, 1) = 12.7062 from tables, standard error 1.
TEST(StandingsReport, HasARowPerTeamWithTheIntervalOverItsPairs) {
  EXPECT_EQ(standings_csv(standings_in(kThreeTeams)),
            "rank,team,points,games,wins,draws,losses,void_games,goals_for,goals_against,mean_diff,"
            "pairs,diff_low95,diff_high95,rating_goals,rating_goals_low95,rating_goals_high95,"
            "bradley_terry,bradley_terry_low95,bradley_terry_high95,wins_share,wins_low95,"
            "wins_high95,draws_share,draws_low95,draws_high95,losses_share,losses_low95,"
            "losses_high95\n"
            "1,bold,7,4,2,1,1,0,4,2,0.5000,2,-12.2062,13.2062,0.3333,,,0.2646,-0.5622,1.1695,"
            "0.5000,0.1500,0.8500,0.2500,0.0456,0.6994,0.2500,0.0456,0.6994\n"
            "2,zone,6,4,1,3,0,0,2,1,0.2500,2,-2.9266,3.4266,0.1667,,,0.2646,-0.5622,1.1695,"
            "0.2500,0.0456,0.6994,0.7500,0.3006,0.9544,0.0000,0.0000,0.6024\n"
            "3,calm,2,4,0,2,2,0,0,3,-0.7500,2,-10.2797,8.7797,-0.5000,,,-0.5293,-1.5253,0.2962,"
            "0.0000,0.0000,0.6024,0.5000,0.1500,0.8500,0.5000,0.1500,0.8500\n");
}

// One game: the strengths are log(3) / 2, and the profile reaches its value at 0.916163
// (strength_profile_test.cpp).
const std::vector<Encounter> kOneWin = {{"bold", "calm", {{2, 0}}}};

TEST(StandingsReport, HasCountsAndGoalsAsJson) {
  EXPECT_EQ(io::json_text(json_of(standings_in(kOneWin))),
            R"([{"team": "bold", "points": 3, "games": 1, "wins": 1, "draws": 0, "losses": 0, )"
            R"("goals_for": 2, "goals_against": 0}, )"
            R"({"team": "calm", "points": 0, "games": 1, "wins": 0, "draws": 0, "losses": 1, )"
            R"("goals_for": 0, "goals_against": 2}])");
}

// The columns of summary.csv that JSON has, unrounded.
TEST(StandingsReport, HasMeansOfMatchupsAsJson) {
  EXPECT_EQ(io::json_text(
                json_of(matchups_in({{"bold", "calm", {{2, 0}, {1, 0}}}, {"calm", "zone", {}}}))),
            R"([{"values": ["bold", "calm"], "games": 2, "void_games": 0, "mean_a": 1.5, )"
            R"("mean_b": 0, "mean_diff": 1.5, "wins_a": 2, "draws": 0, "wins_b": 0}, )"
            R"({"values": ["bold", "zone"], "games": 0, "void_games": 0, "mean_a": null, )"
            R"("mean_b": null, "mean_diff": null, "wins_a": 0, "draws": 0, "wins_b": 0}, )"
            R"({"values": ["calm", "zone"], "games": 0, "void_games": 0, "mean_a": null, )"
            R"("mean_b": null, "mean_diff": null, "wins_a": 0, "draws": 0, "wins_b": 0}])");
}

TEST(StandingsReport, WritesInfinityForTheOpenEndOfAnInterval) {
  const std::string csv = standings_csv(standings_in(kOneWin));
  EXPECT_NE(csv.find("\n1,bold,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",0.5493,-0.9162,inf,1.0000,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",-0.5493,-inf,0.9162,0.0000,"), std::string::npos) << csv;
}

TEST(StandingsReport, SaysAtLeastAndAtMostForAnOpenEnd) {
  const std::string table = io::table_text(standings_table(standings_in(kOneWin)), io::kTextWidth);
  EXPECT_NE(table.find("+0.55 [at least -0.92]\n"), std::string::npos) << table;
  EXPECT_NE(table.find("-0.55 [at most +0.92]\n"), std::string::npos) << table;
}

TEST(StandingsReport, PrintsTablesOfTeamsAndMatchups) {
  const std::string table = io::table_text(standings_table(standings_in(kThreeTeams)), 200);
  EXPECT_NE(table.find("\n1   bold        7       4     2       1      1     4:2"),
            std::string::npos)
      << table;
  const std::string matchups =
      io::table_text(matchups_table(matchups_in(kThreeTeams)), io::kTextWidth);
  EXPECT_NE(matchups.find("\nbold   zone       2   0.50 ± 0.71   1.00 ± 0.00"), std::string::npos)
      << matchups;
}

}  // namespace
}  // namespace autoref::experiments
