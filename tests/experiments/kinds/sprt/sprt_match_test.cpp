// SPRT matches, with made-up games.
#include "experiments/kinds/sprt/sprt_match.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "tests/experiments/reading/mistake.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

constexpr int kManyPairs = 2000;  // more than the others can play while one worker waits its turn

std::string sprt_results_in(const fs::path& folder) {
  return content_of(folder / "results.csv") + content_of(folder / "summary.csv");
}

std::string undisturbed_sprt(int max_pairs = 40) {
  const TemporaryFolder folder;
  run_experiment(small_sprt_match(max_pairs), fake_options(folder.path()));
  return sprt_results_in(folder.path());
}

TEST(SprtMatchSchedule, HasTheGamesOfARoundRobinOfItsTwoTeams) {
  const std::vector<ScheduledGame> games = small_sprt_match(3).experiment().games();
  const std::vector<ScheduledGame> robins = small_roundrobin({6, 5}, 3).experiment().games();
  ASSERT_EQ(games.size(), robins.size());
  for (std::size_t i = 0; i < games.size(); ++i) {
    EXPECT_EQ(games[i].id, robins[i].id);
    EXPECT_EQ(game::configuration_hash(games[i].settings.combined()),
              game::configuration_hash(robins[i].settings.combined()));
  }
}

TEST(SprtMatchRun, EndsWithThePairThatDecidesIt) {
  const TemporaryFolder folder;
  const ExperimentReport report = run_experiment(small_sprt_match(), fake_options(folder.path()));
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 20);  // min_pairs pairs suffice, since the evidence is clear
  EXPECT_NE(io::text_of(report.results.table)
                .find("decided for d1: the mean lead of team0 over team1 in goals "
                      "per game is nearer to -4 than to 0"),
            std::string::npos)
      << io::text_of(report.results.table);
  EXPECT_NE(content_of(folder / "summary.csv").find(",d1,10,0,"), std::string::npos);
}

TEST(SprtMatchRun, GivesTheSameResultsForEveryNumberOfWorkers) {
  const std::string expected = undisturbed_sprt(kManyPairs);
  for (const int workers : {1, 2, 5}) {
    const TemporaryFolder folder;
    ExperimentOptions options = fake_options(folder.path());
    options.workers = workers;
    options.play = slow_fake_game;
    EXPECT_LT(run_experiment(small_sprt_match(kManyPairs), options).played, 2 * kManyPairs);
    EXPECT_EQ(sprt_results_in(folder.path()), expected);
  }
}

TEST(SprtMatchRun, ResumesAfterAnInterrupt) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = interrupting();
  EXPECT_TRUE(run_experiment(small_sprt_match(), options).is_interrupted);
  run_experiment(small_sprt_match(), fake_options(folder.path()));
  EXPECT_EQ(sprt_results_in(folder.path()), undisturbed_sprt());
}

TEST(SprtMatchRun, PlaysNothingOnceItIsDecided) {
  const TemporaryFolder folder;
  run_experiment(small_sprt_match(), fake_options(folder.path()));
  const ExperimentReport report = run_experiment(small_sprt_match(), fake_options(folder.path()));
  EXPECT_EQ(report.played, 0);
  EXPECT_TRUE(report.is_complete);
}

TEST(SprtMatchRun, EndsUndecidedAfterItsLastPair) {
  Scenario scenario = small_sprt_match(12);
  auto& match = *scenario.as<SprtMatch>();
  match.sprt.d0 = -4.001;
  const TemporaryFolder folder;
  const ExperimentReport report = run_experiment(scenario, fake_options(folder.path()));
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 24);
  EXPECT_NE(content_of(folder / "summary.csv").find(",undecided,12,0,"), std::string::npos);
}

TEST(SprtMatchRun, LeavesPairsWithAVoidLegOutOfTheTest) {
  const std::uint64_t void_seed =
      small_sprt_match().experiment().games()[3].settings.combined().seed;
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = [void_seed](const game::GameConfiguration& game) -> game::GameRecord {
    if (game.seed == void_seed) throw std::runtime_error("no");
    return fake_game(game);
  };
  const ExperimentReport report = run_experiment(small_sprt_match(), options);
  EXPECT_EQ(report.games, 22);
  EXPECT_EQ(report.void_games, 1);
  EXPECT_NE(content_of(folder / "summary.csv").find(",d1,10,1,"), std::string::npos);
  EXPECT_NE(io::text_of(report.results.table).find("1 pairs with a void leg"), std::string::npos);
}

ExperimentReport run_sprt_shard(const fs::path& folder, int number) {
  ExperimentOptions options = fake_options(folder);
  options.shard = {number, 2};
  return run_experiment(small_sprt_match(), options);
}

TEST(SprtMatchShards, StopOnceTheirCombinedRowsDecideTheMatch) {
  const TemporaryFolder folder;
  EXPECT_FALSE(run_sprt_shard(folder.path(), 1).is_complete);
  const ExperimentReport report = run_sprt_shard(folder.path(), 0);
  EXPECT_TRUE(report.is_complete);
  EXPECT_LT(report.played, 40);
  EXPECT_EQ(sprt_results_in(folder.path()), undisturbed_sprt());
}

TEST(SprtMatchShards, GiveTheSameResultsWhenTheirRowsAreMerged) {
  const TemporaryFolder folder;
  for (const int number : {0, 1}) {
    const TemporaryFolder own;
    EXPECT_EQ(run_sprt_shard(own.path(), number).played, 40);
    fs::copy(own.path(), folder.path(),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  const ResultFolder whole = open_results(folder.path());
  EXPECT_TRUE(whole.is_complete());
  EXPECT_EQ(whole.beyond, 60);
  write_results(whole.path, whole.scenario, whole.format, whole.completed_games.done);
  EXPECT_EQ(sprt_results_in(folder.path()), undisturbed_sprt());
}

// The state after this many pairs, one of which is missing.
SprtMatchState state_without(int missing_pair, int pairs) {
  const Scenario scenario = small_sprt_match();
  RowsById rows;
  for (const ScheduledGame& game : scenario.experiment().games()) {
    if (game.pair == missing_pair || game.pair > pairs) continue;
    rows[game.id].record = fake_game(game::resolved(game.settings.combined()));
  }
  return state_of(*scenario.as<SprtMatch>(), rows);
}

TEST(SprtMatchState, StopsAtTheFirstMissingPair) {
  EXPECT_EQ(state_without(5, 40).test.pairs, 4);
  EXPECT_FALSE(state_without(5, 40).is_decided);
  EXPECT_EQ(state_without(12, 40).last_pair, 10);
  EXPECT_TRUE(state_without(12, 40).is_decided);
}

TEST(SprtMatchState, IsUndecidedBeforeTheFirstPair) {
  const SprtMatchState state = state_without(0, 0);
  EXPECT_EQ(state.last_pair, 0);
  EXPECT_EQ(name_of(state.test.verdict), "none");
}

const std::string kSprtTop = "schema: 1\nkind: sprt\nseed: 7\n";
const std::string kSprtTeams = "teams: { zone: {}, bold: { strategy: dummy } }\n";

TEST(ReadSprtMatch, ReadsItsTestWithDefaultErrorRates) {
  const SprtMatch match =
      *read_scenario_text(kSprtTop + kSprtTeams + "sprt: { d0: -1, d1: 0.5, max_pairs: 60 }\n",
                          "x.yaml")
           .as<SprtMatch>();
  EXPECT_EQ(matchup_of(match), (Matchup{"bold", "zone"}));
  EXPECT_EQ(match.sprt.d0, -1);
  EXPECT_EQ(match.sprt.d1, 0.5);
  EXPECT_EQ(match.sprt.alpha, 0.05);
  EXPECT_EQ(match.sprt.min_pairs, 10);
  EXPECT_EQ(match.sprt.max_pairs, 60);
}

TEST(EffectiveConfiguration, OfAMatchReadsBackEqual) {
  const std::string text = effective_text(small_sprt_match());
  EXPECT_EQ(effective_text(read_scenario_text(text, "x.yaml")), text);
}

class WrongSprtMatch : public testing::TestWithParam<Mistake> {};

TEST_P(WrongSprtMatch, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongSprtMatch,
    testing::Values(
        Mistake{"NoTest", kSprtTop + kSprtTeams, "x.yaml:1:1: ", {"'sprt' is missing"}},
        Mistake{"OneTeam",
                kSprtTop + "teams: { zone: {} }\nsprt: { d0: 0, d1: 1, max_pairs: 20 }\n",
                "x.yaml:4:1: teams: ",
                {"expected 2 teams", "found 1"}},
        Mistake{"ThreeTeams",
                kSprtTop + "teams: { zone: {}, bold: {}, calm: {} }\n",
                "x.yaml:4:1: teams: ",
                {"expected 2 teams", "found 3"}},
        Mistake{"NoEnd",
                kSprtTop + kSprtTeams + "sprt: { d0: 0, d1: 1 }\n",
                "x.yaml:5:1: sprt: ",
                {"'max_pairs' is missing"}},
        Mistake{"EqualHypotheses",
                kSprtTop + kSprtTeams + "sprt: { d0: 1, d1: 1, max_pairs: 20 }\n",
                "x.yaml:5:16: sprt.d1: ",
                {"must differ from d0"}},
        Mistake{"ErrorRateOutOfRange",
                kSprtTop + kSprtTeams + "sprt: { d0: 0, d1: 1, alpha: 0.5, max_pairs: 20 }\n",
                "x.yaml:5:30: sprt.alpha: ",
                {"above 0 and at most 0.49", "found '0.5'"}},
        Mistake{"MaximumBelowTheMinimum",
                kSprtTop + kSprtTeams + "sprt: { d0: 0, d1: 1, max_pairs: 5 }\n",
                "x.yaml:5:23: sprt.max_pairs: ",
                {"at least min_pairs, which is 10", "found 5"}},
        Mistake{"UnknownKeyOfTheTest",
                kSprtTop + kSprtTeams + "sprt: { d0: 0, d2: 1, max_pairs: 5 }\n",
                "x.yaml:5:16: sprt: ",
                {"'d2'", "did you mean"}},
        Mistake{"Pairs",
                kSprtTop + kSprtTeams + "pairs: 5\n",
                "x.yaml:5:1: ",
                {"unknown key 'pairs'"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
