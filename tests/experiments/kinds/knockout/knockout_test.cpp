// Knockouts, with made-up games.
#include "experiments/kinds/knockout/knockout.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/knockout/bracket.hpp"
#include "experiments/kinds/knockout/knockout_report.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/result_folder.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

// team0 is the best seed. Team n has n + 1 robots.
Knockout knockout_of(int teams) {
  Knockout knockout;
  for (int i = 0; i < teams; ++i) {
    knockout.order.push_back("team" + std::to_string(i));
    knockout.teams[knockout.order.back()].robots = i + 1;
  }
  knockout.seed = 2026;
  return knockout;
}

// The team with fewer robots, here the better seed, wins 2:1.
game::GameRecord won_by_the_better(const game::GameConfiguration& game) {
  game::GameRecord record = fake_game(game);
  record.goals_a = game.a.robots.size() < game.b.robots.size() ? 2 : 1;
  record.goals_b = 3 - record.goals_a;
  return record;
}

game::GameRecord won_by_the_worse(const game::GameConfiguration& game) {
  game::GameRecord record = won_by_the_better(game);
  std::swap(record.goals_a, record.goals_b);
  return record;
}

game::GameRecord drawn_game(const game::GameConfiguration& game) {
  game::GameRecord record = fake_game(game);
  record.goals_a = record.goals_b = 1;
  return record;
}

ExperimentReport run(const Knockout& knockout, const fs::path& folder,
                     const std::function<game::GameRecord(const game::GameConfiguration&)>& play,
                     ShardIndex shard = {}) {
  ExperimentOptions options = fake_options(folder);
  options.play = play;
  options.shard = shard;
  return run_experiment({"A test.", knockout}, options);
}

std::string knockout_results_in(const fs::path& folder) {
  return content_of(folder / "results.csv") + content_of(folder / "summary.csv");
}

std::string undisturbed_knockout(const Knockout& knockout) {
  const TemporaryFolder folder;
  run(knockout, folder.path(), won_by_the_worse);
  return knockout_results_in(folder.path());
}

std::vector<std::string> knockout_ids_of(const std::vector<ScheduledGame>& games) {
  std::vector<std::string> ids;
  for (const ScheduledGame& game : games) ids.push_back(game.id);
  return ids;
}

TEST(Bracket, OfEightTeamsKeepsTheBestSeedsApart) {
  const std::vector<std::string> expected = {
      "team0~team7-p0001-1", "team3~team4-p0002-1", "team1~team6-p0003-1", "team2~team5-p0004-1",
      "team0~team3-p0005-1", "team1~team2-p0006-1", "team0~team1-p0007-1"};
  EXPECT_EQ(knockout_ids_of(knockout_of(8).games()), expected);
}

TEST(Bracket, OfFiveTeamsGivesTheThreeBestAByeInTheFirstRound) {
  const std::vector<std::string> expected = {"team3~team4-p0001-1", "team0~team3-p0002-1",
                                             "team1~team2-p0003-1", "team0~team1-p0004-1"};
  EXPECT_EQ(knockout_ids_of(knockout_of(5).games()), expected);
}

// Quarter-final 1 leads to the lower half of semi-final 1, beside the bye of the best seed.
TEST(Bracket, PlacesTiesBesideThoseThatLeadToThem) {
  const std::vector<Tie> ties = bracket_of(knockout_of(5), [](Tie&) {});
  ASSERT_EQ(ties.size(), 4U);
  EXPECT_EQ(ties[0].place, (BracketPlace{4, 1}));
  EXPECT_EQ(ties[1].place, (BracketPlace{2, 0}));
  EXPECT_EQ(ties[2].place, (BracketPlace{2, 1}));
  EXPECT_EQ(ties[3].place, (BracketPlace{1, 0}));
}

TEST(Bracket, SaysWhereUnknownTeamsWillComeFrom) {
  Knockout knockout = knockout_of(5);
  knockout.third_place = true;
  const std::vector<TieResult> ties = tie_results(bracket_of(knockout, RowsById{}), {});
  ASSERT_EQ(ties.size(), 5U);
  EXPECT_EQ(ties[1].teams[0].name, "team0");
  EXPECT_EQ(ties[1].teams[1].name, "winner of quarter-final 1");
  EXPECT_EQ(ties[3].teams[0].name, "winner of semi-final 1");
  EXPECT_EQ(ties[4].teams[1].name, "loser of semi-final 2");
  EXPECT_FALSE(ties[4].teams[1].is_known);
}

TEST(Bracket, NamesItsRounds) {
  EXPECT_EQ(name_of_round(1), "final");
  EXPECT_EQ(name_of_round(2), "semi-finals");
  EXPECT_EQ(name_of_round(4), "quarter-finals");
  EXPECT_EQ(name_of_round(32), "round of 64");
}

TEST(Bracket, OfTwoTeamsIsAFinal) {
  const std::vector<Tie> ties = bracket_of(knockout_of(2), [](Tie&) {});
  ASSERT_EQ(ties.size(), 1U);
  EXPECT_EQ(ties[0].name, "final");
}

TEST(Bracket, HasOneTieFewerThanTeams) {
  for (const int teams : {2, 3, 5, 6, 11, 16, 33, 64}) {
    EXPECT_EQ(
        [teams] {
          Knockout knockout = knockout_of(teams);
          for (auto& [name, team] : knockout.teams) team.robots = 6;
          return knockout;
        }()
            .games()
            .size(),
        static_cast<std::size_t>(teams - 1));
  }
}

TEST(Bracket, KnowsOnlyTheTiesThatDependOnNoOther) {
  const std::vector<Tie> ties = bracket_of(knockout_of(5), [](Tie&) {});
  EXPECT_EQ(knockout_ids_of(games_of(knockout_of(5), ties)),
            (std::vector<std::string>{"team3~team4-p0001-1", "team1~team2-p0003-1"}));
  EXPECT_EQ(ties[1].a, "team0");
  EXPECT_FALSE(ties[1].b.has_value());
  EXPECT_EQ(ties[0].name, "quarter-final 1");
}

TEST(KnockoutGames, ChangeEndsAndSeedWhenReplayed) {
  std::vector<Tie> ties = bracket_of(knockout_of(2), [](Tie&) {});
  ties[0].games = {"team0~team1-p0001-1"};
  const std::vector<ScheduledGame> games = games_of(knockout_of(2), ties);
  ASSERT_EQ(games.size(), 2U);
  EXPECT_EQ(games[0].settings.combined().match.a_plays, Side::kWest);
  EXPECT_EQ(games[1].settings.combined().match.a_plays, Side::kEast);
  EXPECT_NE(games[0].settings.combined().seed, games[1].settings.combined().seed);
  EXPECT_EQ(games[0].unit, games[1].unit);
}

TEST(KnockoutRun, PlaysUntilTheFinalIsWon) {
  const TemporaryFolder folder;
  const ExperimentReport report = run(knockout_of(5), folder.path(), won_by_the_worse);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 4);
  EXPECT_NE(content_of(folder / "summary.csv").find("4,final,team2,team4,1,2,,,1,0,goals,team4\n"),
            std::string::npos)
      << content_of(folder / "summary.csv");
  EXPECT_NE(io::text_of(report.results.table).find("the winner is team4"), std::string::npos);
}

TEST(KnockoutRun, GivesTheSameResultsForEveryNumberOfWorkers) {
  const std::string expected = undisturbed_knockout(knockout_of(7));
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = won_by_the_worse;
  options.workers = 3;
  run_experiment({"A test.", knockout_of(7)}, options);
  EXPECT_EQ(knockout_results_in(folder.path()), expected);
}

TEST(KnockoutRun, ResumesAfterAnInterrupt) {
  const TemporaryFolder folder;
  const PlayGame interrupted = interrupting(won_by_the_worse);
  // Each run plays one game, so some runs stop after the last game of a round.
  EXPECT_TRUE(run(knockout_of(3), folder.path(), interrupted).is_interrupted);
  EXPECT_EQ(run(knockout_of(3), folder.path(), won_by_the_worse).played, 1);
  EXPECT_EQ(knockout_results_in(folder.path()), undisturbed_knockout(knockout_of(3)));
}

TEST(KnockoutRun, ReplaysADrawnTie) {
  const TemporaryFolder folder;
  const auto drawn_at_first = [](const game::GameConfiguration& game) {
    return game.match.a_plays == Side::kWest ? drawn_game(game) : won_by_the_worse(game);
  };
  const ExperimentReport report = run(knockout_of(2), folder.path(), drawn_at_first);
  EXPECT_EQ(report.played, 2);
  EXPECT_EQ(report.games, 2);
  EXPECT_NE(io::text_of(report.results.table).find("goals in game 2"), std::string::npos)
      << io::text_of(report.results.table);
}

TEST(KnockoutRun, AdvancesTheBetterSeedAfterSixDraws) {
  const TemporaryFolder folder;
  const ExperimentReport report = run(knockout_of(2), folder.path(), drawn_game);
  EXPECT_EQ(report.played, 6);
  EXPECT_NE(content_of(folder / "summary.csv").find(",6,0,better seed,team0\n"), std::string::npos);
  EXPECT_NE(io::text_of(report.results.table).find("better seed after 6 games"), std::string::npos);
}

TEST(KnockoutRun, TreatsAVoidGameAsADraw) {
  const TemporaryFolder folder;
  const ExperimentReport report = run(
      knockout_of(2), folder.path(),
      [](const game::GameConfiguration&) -> game::GameRecord { throw std::runtime_error("no"); });
  EXPECT_EQ(report.void_games, 6);
  EXPECT_NE(io::text_of(report.results.table).find("better seed after 6 games, 6 void"),
            std::string::npos)
      << io::text_of(report.results.table);
}

TEST(KnockoutRun, ReportsHowATieWasDecided) {
  const TemporaryFolder folder;
  const auto shot_out = [](const game::GameConfiguration& game) {
    game::GameRecord record = drawn_game(game);
    record.end_reason = game::EndReason::kShootout;
    record.shootout = {{2, 4}};
    return record;
  };
  const ExperimentReport report = run(knockout_of(2), folder.path(), shot_out);
  EXPECT_NE(content_of(folder / "summary.csv").find(",1,1,2,4,1,0,shoot-out,team1\n"),
            std::string::npos);
  EXPECT_NE(io::text_of(report.results.table).find("1:1 (2:4)"), std::string::npos);
}

TEST(KnockoutRun, ShowsGoalsAndShootOutBesideTheTeamsOfATie) {
  const TemporaryFolder folder;
  const ExperimentReport report = run(knockout_of(2), folder.path(), [](const auto& game) {
    game::GameRecord record = drawn_game(game);
    record.end_reason = game::EndReason::kShootout;
    record.shootout = {{2, 4}};
    return record;
  });
  ASSERT_EQ(report.results.ties.size(), 1U);
  const auto& [a, b] = report.results.ties[0].teams;
  EXPECT_EQ(a.goals, "1 (2)");
  EXPECT_EQ(b.goals, "1 (4)");
  EXPECT_FALSE(a.has_won);
  EXPECT_TRUE(b.has_won);
  EXPECT_EQ(report.results.ties[0].decision, "shoot-out");
}

TEST(KnockoutRun, LetsTheLosersOfTheSemiFinalsPlayForThirdPlace) {
  Knockout knockout = knockout_of(4);
  knockout.third_place = true;
  const TemporaryFolder folder;
  const ExperimentReport report = run(knockout, folder.path(), won_by_the_better);
  EXPECT_EQ(report.played, 4);
  EXPECT_NE(content_of(folder / "summary.csv").find("4,third place,team2,team3,2,1,,,1,0,goals"),
            std::string::npos)
      << content_of(folder / "summary.csv");
}

TEST(KnockoutRun, PlaysOneMoreGameWhenThirdPlaceIsAdded) {
  const TemporaryFolder folder;
  Knockout knockout = knockout_of(4);
  run(knockout, folder.path(), won_by_the_better);
  knockout.third_place = true;
  EXPECT_EQ(run(knockout, folder.path(), won_by_the_better).played, 1);
}

TEST(KnockoutShards, WaitForEachOtherAndGiveTheSameResults) {
  const TemporaryFolder folder;
  ExperimentReport report = run(knockout_of(8), folder.path(), won_by_the_worse, {0, 2});
  EXPECT_TRUE(report.is_waiting);
  EXPECT_EQ(report.played, 2);
  EXPECT_EQ(report.games, 7);
  for (int turn = 1; turn < 7 && !report.is_complete; ++turn) {
    report = run(knockout_of(8), folder.path(), won_by_the_worse, {turn % 2, 2});
  }
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(knockout_results_in(folder.path()), undisturbed_knockout(knockout_of(8)));
}

TEST(KnockoutFolder, IsReadEvenIfUnfinished) {
  const TemporaryFolder folder;
  run(knockout_of(8), folder.path(), won_by_the_worse, {0, 2});
  const ResultFolder results = open_results(folder.path());
  EXPECT_FALSE(results.is_complete());
  EXPECT_EQ(results.completed_games.done.size(), 2U);
  EXPECT_EQ(results.games.size(), 4U);
  EXPECT_EQ(results.needed, 7U);
}

}  // namespace
}  // namespace autoref::experiments
