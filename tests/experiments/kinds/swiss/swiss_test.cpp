// Swiss tournaments, with made-up games.
#include "experiments/kinds/swiss/swiss.hpp"

#include <gtest/gtest.h>

#include <set>

#include "experiments/kinds/swiss/swiss_report.hpp"
#include "experiments/kinds/swiss/swiss_rounds.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/run/run_games.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;
using SwissIds = std::vector<std::string>;

// Team n has n + 1 robots.
Swiss swiss_of(int teams, int rounds, int pairs = 1) {
  Swiss swiss;
  for (int i = 0; i < teams; ++i) swiss.teams["team" + std::to_string(i)].robots = i + 1;
  swiss.rounds = rounds;
  swiss.pairs = pairs;
  swiss.seed = 2026;
  return swiss;
}

// The team with more robots wins 2:1.
game::GameRecord won_by_the_larger(const game::GameConfiguration& game) {
  game::GameRecord record = fake_game(game);
  record.goals_a = game.a.robots.size() > game.b.robots.size() ? 2 : 1;
  record.goals_b = 3 - record.goals_a;
  return record;
}

game::GameRecord void_game(const game::GameConfiguration&) { throw std::runtime_error("no"); }

RowsById rows_of_games(
    const std::vector<ScheduledGame>& games,
    const std::function<game::GameRecord(const game::GameConfiguration&)>& play) {
  RowsById rows;
  for (const ScheduledGame& game : games) {
    rows[game.id] = row_of(game);
    rows[game.id].record = play(resolved(game));
  }
  return rows;
}

ExperimentReport run_swiss(
    const Swiss& swiss, const fs::path& folder,
    const std::function<game::GameRecord(const game::GameConfiguration&)>& play,
    ShardIndex shard = {}) {
  ExperimentOptions options = fake_options(folder);
  options.play = play;
  options.shard = shard;
  return run_experiment({"A test.", swiss}, options);
}

std::string swiss_results_in(const fs::path& folder) {
  std::string text;
  for (const char* file : {"results.csv", "summary.csv", "standings.csv", "rounds.csv"})
    text += content_of(folder / file);
  return text;
}

std::string undisturbed_swiss(const Swiss& swiss) {
  const TemporaryFolder folder;
  EXPECT_TRUE(run_swiss(swiss, folder.path(), won_by_the_larger).is_complete);
  return swiss_results_in(folder.path());
}

SwissIds ids_of_swiss(const std::vector<ScheduledGame>& games) {
  SwissIds ids;
  for (const ScheduledGame& game : games) ids.push_back(game.id);
  return ids;
}

TEST(SwissDraw, HasEveryTeamOnceAndFollowsTheSeed) {
  Swiss swiss = swiss_of(8, 1);
  const std::vector<std::string> draw = draw_of(swiss);
  EXPECT_EQ(std::set<std::string>(draw.begin(), draw.end()).size(), 8U);
  EXPECT_FALSE(std::is_sorted(draw.begin(), draw.end()));
  EXPECT_EQ(draw_of(swiss), draw);
  swiss.seed = 2027;
  EXPECT_NE(draw_of(swiss), draw);
}

// Each of the 24 orders of four teams is drawn in 100 of 2400 draws, with a standard deviation of
// 10.
TEST(SwissDraw, IsFair) {
  std::map<std::vector<std::string>, int> counts;
  Swiss swiss = swiss_of(4, 1);
  for (swiss.seed = 0; swiss.seed < 2400; ++swiss.seed) ++counts[draw_of(swiss)];
  EXPECT_EQ(counts.size(), 24U);
  for (const auto& [order, count] : counts) EXPECT_NEAR(count, 100, 50);
}

TEST(SwissGames, OfRoundOneArePairedByTheDraw) {
  const Swiss swiss = swiss_of(4, 1);
  const std::vector<std::string> draw = draw_of(swiss);
  const auto first = std::minmax(draw[0], draw[2]);
  const auto second = std::minmax(draw[1], draw[3]);
  const std::string one = first.first + "~" + first.second;
  const std::string other = second.first + "~" + second.second;
  EXPECT_EQ(ids_of_swiss(swiss.games()),
            (SwissIds{one + "-p0001-1", one + "-p0001-2", other + "-p0001-1", other + "-p0001-2"}));
}

TEST(SwissGames, OfAllRoundsAreKnownInNumber) {
  EXPECT_EQ(swiss_of(6, 3, 2).games().size(), 36U);
  EXPECT_EQ(swiss_of(5, 5).games().size(), 20U);
  EXPECT_EQ(swiss_of(6, 3, 2).games_of_a_round(), 12U);
}

TEST(SwissGames, HavePairNumbersOfTheirRound) {
  const std::vector<ScheduledGame> games = swiss_of(4, 3, 2).games();
  ASSERT_EQ(games.size(), 24U);
  for (std::size_t i = 0; i < games.size(); ++i)
    EXPECT_EQ(games[i].pair, static_cast<int>(i / 4) + 1) << games[i].id;
}

TEST(SwissGames, ChangeSidesAndTheFirstKickOff) {
  const std::vector<ScheduledGame> games = swiss_of(2, 1, 3).games();
  ASSERT_EQ(games.size(), 6U);
  const auto match = [&games](std::size_t i) { return games[i].settings.combined().match; };
  EXPECT_EQ(match(0).a_plays, Side::kWest);
  EXPECT_EQ(match(1).a_plays, Side::kEast);
  EXPECT_EQ(match(0).first_kickoff, match(1).first_kickoff);
  EXPECT_NE(match(0).first_kickoff, match(2).first_kickoff);
}

TEST(SwissGames, OfOnePairHaveOneUnitAndTheirShardsChange) {
  const std::vector<ScheduledGame> games = swiss_of(4, 1, 2).games();
  ASSERT_EQ(games.size(), 8U);
  EXPECT_EQ(games[0].unit, games[1].unit);
  EXPECT_NE(games[1].unit, games[2].unit);
  const ShardIndex shard{0, 2};
  EXPECT_NE(shard.has(games[0].unit, games[0].variants),
            shard.has(games[4].unit, games[4].variants));
}

TEST(SwissSchedule, KnowsRoundOneBeforeTheFirstGame) {
  const Schedule schedule = swiss_of(6, 3).schedule({});
  EXPECT_EQ(schedule.games.size(), 6U);
  EXPECT_EQ(schedule.needed, 18U);
}

TEST(SwissSchedule, KnowsARoundOnceTheOneBeforeIsComplete) {
  const Swiss swiss = swiss_of(6, 3);
  const std::vector<ScheduledGame> first = swiss.schedule({}).games;
  RowsById rows = rows_of_games(first, won_by_the_larger);
  EXPECT_EQ(swiss.schedule(rows).games.size(), 12U);
  rows.erase(first.back().id);
  EXPECT_EQ(ids_of_swiss(swiss.schedule(rows).games), ids_of_swiss(first));
}

TEST(SwissSchedule, GoesOnAfterARoundOfVoidGames) {
  const Swiss swiss = swiss_of(4, 2);
  RowsById rows = rows_of_games(swiss.schedule({}).games, won_by_the_larger);
  for (auto& [id, row] : rows) row.record = void_record("no");
  EXPECT_EQ(swiss.schedule(rows).games.size(), 8U);
  EXPECT_EQ(rounds_of(swiss, rows).ranking, draw_of(swiss));
}

// Rows of another round, for example of a run with more pairs, do not count.
TEST(SwissSchedule, IgnoresRowsOfOtherGames) {
  const Swiss swiss = swiss_of(4, 2);
  RowsById rows = rows_of_games(swiss_of(4, 3).games(), won_by_the_larger);
  std::erase_if(rows, [](const auto& row) { return row.second.pair != 3; });
  EXPECT_EQ(ids_of_swiss(swiss.schedule(rows).games), ids_of_swiss(swiss.schedule({}).games));
}

TEST(SwissRanking, IsByPointsThenGoalDifferenceThenTheDraw) {
  const Swiss swiss = swiss_of(4, 2);
  const std::vector<ScheduledGame> games = swiss.schedule({}).games;
  RowsById rows = rows_of_games(games, [](const game::GameConfiguration& game) {
    game::GameRecord record = fake_game(game);
    record.goals_a = record.goals_b = 1;
    return record;
  });
  EXPECT_EQ(rounds_of(swiss, rows).ranking, draw_of(swiss));
  // One side wins the first meeting by 1, another the second by 5.
  const auto win = [&rows](const ScheduledGame& game, int goals) {
    rows[game.id].record.goals_a = 1 + goals;
  };
  for (const std::size_t i : {0U, 1U}) win(games[i], 1);
  for (const std::size_t i : {2U, 3U}) win(games[i], 5);
  EXPECT_EQ(rounds_of(swiss, rows).ranking,
            (std::vector<std::string>{games[2].team_a, games[0].team_a, games[0].team_b,
                                      games[2].team_b}));
}

TEST(SwissRanking, HasATeamWithAByeAboveThoseThatHaveDrawn) {
  const Swiss swiss = swiss_of(3, 1);
  EXPECT_EQ(rounds_if_drawn(swiss).ranking.front(), draw_of(swiss).back());
}

TEST(SwissRun, LetsTheBestTeamWinWithoutRematches) {
  const TemporaryFolder folder;
  const ExperimentReport report = run_swiss(swiss_of(6, 3), folder.path(), won_by_the_larger);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 18);
  EXPECT_EQ(report.results.groups.size(), 9U);
  ASSERT_EQ(report.results.standings.size(), 6U);
  EXPECT_EQ(report.results.standings[0].team, "team5");
  EXPECT_EQ(report.results.standings[0].points(), 18);
  EXPECT_TRUE(are_rated(report.results.standings));
}

TEST(SwissRun, CountsAByeAsAMeetingWon) {
  const TemporaryFolder folder;
  const Swiss swiss = swiss_of(3, 1, 2);
  const ExperimentReport report = run_swiss(swiss, folder.path(), won_by_the_larger);
  const std::string bye = draw_of(swiss).back();
  ASSERT_EQ(report.results.standings.size(), 3U);
  const auto its = std::find_if(report.results.standings.begin(), report.results.standings.end(),
                                [&bye](const Standing& one) { return one.team == bye; });
  EXPECT_EQ(its->points(), 12);
  EXPECT_EQ(its->games(), 0);
  EXPECT_NE(content_of(folder / "rounds.csv").find("1," + bye + ",,0,0,12,\n"), std::string::npos)
      << content_of(folder / "rounds.csv");
  EXPECT_NE(io::text_of(report.results.table).find("A bye is worth 12 points"), std::string::npos);
}

TEST(SwissRun, DoesNotRateTeamsThatNoGamesLink) {
  const TemporaryFolder folder;
  EXPECT_FALSE(
      are_rated(run_swiss(swiss_of(4, 1), folder.path(), won_by_the_larger).results.standings));
}

TEST(SwissRun, ShowsTheRounds) {
  const TemporaryFolder folder;
  const ExperimentReport report = run_swiss(swiss_of(2, 1), folder.path(), won_by_the_larger);
  EXPECT_EQ(content_of(folder / "rounds.csv"),
            "round,team_a,team_b,games,void_games,points_a,points_b\n1,team0,team1,2,0,0,6\n");
  EXPECT_EQ(io::text_of(report.results.table)
                .find("round       a   points   b\n"
                      "    1   team0   0:6      team1\n"),
            0U)
      << io::text_of(report.results.table);
}

TEST(SwissRun, LeavesOutVoidGames) {
  const TemporaryFolder folder;
  const ExperimentReport report = run_swiss(swiss_of(4, 2), folder.path(), void_game);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.void_games, 8);
  EXPECT_EQ(report.results.standings[0].points(), 0);
}

TEST(SwissRun, GivesTheSameResultsForEveryNumberOfWorkers) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = won_by_the_larger;
  options.workers = 3;
  run_experiment({"A test.", swiss_of(7, 4)}, options);
  EXPECT_EQ(swiss_results_in(folder.path()), undisturbed_swiss(swiss_of(7, 4)));
}

TEST(SwissRun, ResumesAfterAnInterrupt) {
  const TemporaryFolder folder;
  const PlayGame interrupted = interrupting(won_by_the_larger);
  EXPECT_TRUE(run_swiss(swiss_of(5, 3), folder.path(), interrupted).is_interrupted);
  EXPECT_TRUE(run_swiss(swiss_of(5, 3), folder.path(), won_by_the_larger).is_complete);
  EXPECT_EQ(swiss_results_in(folder.path()), undisturbed_swiss(swiss_of(5, 3)));
}

TEST(SwissRun, ContinuesWithMoreRounds) {
  const TemporaryFolder folder;
  run_swiss(swiss_of(6, 2), folder.path(), won_by_the_larger);
  EXPECT_EQ(run_swiss(swiss_of(6, 3), folder.path(), won_by_the_larger).played, 6);
  EXPECT_EQ(swiss_results_in(folder.path()), undisturbed_swiss(swiss_of(6, 3)));
}

TEST(SwissRun, WithMorePairsEndsAsIfItHadBegunWithThem) {
  const TemporaryFolder folder;
  run_swiss(swiss_of(6, 3), folder.path(), won_by_the_larger);
  run_swiss(swiss_of(6, 3, 2), folder.path(), won_by_the_larger);
  EXPECT_EQ(swiss_results_in(folder.path()), undisturbed_swiss(swiss_of(6, 3, 2)));
}

TEST(SwissRun, WithOtherTeamsEndsAsIfItHadBegunWithThem) {
  const TemporaryFolder folder;
  run_swiss(swiss_of(6, 3), folder.path(), won_by_the_larger);
  run_swiss(swiss_of(5, 3), folder.path(), won_by_the_larger);
  EXPECT_EQ(swiss_results_in(folder.path()), undisturbed_swiss(swiss_of(5, 3)));
}

TEST(SwissRun, SaysThatWithMorePairsSomeGamesMayNotCount) {
  const Scenario there = {"", swiss_of(6, 3)};
  EXPECT_EQ(note_on_pairs({"", swiss_of(6, 3, 2)}, there, 12),
            "the folder had 1 pairs, now 2; the games already played count if they still belong to "
            "the experiment");
}

TEST(SwissShards, WaitForEachOtherAndGiveTheSameResults) {
  const TemporaryFolder folder;
  ExperimentReport report = run_swiss(swiss_of(6, 3), folder.path(), won_by_the_larger, {0, 2});
  EXPECT_TRUE(report.is_waiting);
  EXPECT_EQ(report.games, 18);
  for (int turn = 1; turn < 8 && !report.is_complete; ++turn)
    report = run_swiss(swiss_of(6, 3), folder.path(), won_by_the_larger, {turn % 2, 2});
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(swiss_results_in(folder.path()), undisturbed_swiss(swiss_of(6, 3)));
}

TEST(SwissFolder, IsReadEvenIfUnfinished) {
  const TemporaryFolder folder;
  run_swiss(swiss_of(8, 3), folder.path(), won_by_the_larger, {0, 2});
  const ResultFolder results = open_results(folder.path());
  EXPECT_FALSE(results.is_complete());
  EXPECT_EQ(results.completed_games.done.size(), 4U);
  EXPECT_EQ(results.games.size(), 8U);
  EXPECT_EQ(results.needed, 24U);
}

}  // namespace
}  // namespace autoref::experiments
