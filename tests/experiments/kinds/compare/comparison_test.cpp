// Comparisons of two teams, with made-up games.
#include "experiments/kinds/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/kinds/compare/comparison_report.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/result_folder.hpp"
#include "soccer/random.hpp"
#include "tests/experiments/reading/mistake.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

Scenario comparison_against(const std::vector<int>& robots, int max_pairs = 40) {
  Scenario scenario = small_comparison(max_pairs);
  auto& comparison = *scenario.as<Comparison>();
  for (const int count : robots)
    comparison.against["team" + std::to_string(comparison.against.size())].robots = count;
  return scenario;
}

// A game in which both teams score a random number of goals, and one of them `lead` more.
game::GameRecord game_with(double lead, const game::GameConfiguration& game) {
  game::GameRecord record = fake_game(game);
  RandomStream random(game.seed);
  record.goals_a = static_cast<int>(std::abs(2 * random.normal()));
  record.goals_b = static_cast<int>(std::abs(2 * random.normal()));
  const int goals = static_cast<int>(std::abs(lead));
  (lead > 0 ? record.goals_a : record.goals_b) += goals;
  record.goals_by_half = {{record.goals_a, record.goals_b}, {0, 0}};
  return record;
}

ExperimentReport played(const Scenario& scenario, const fs::path& folder, double lead,
                        int workers = 1) {
  ExperimentOptions options = fake_options(folder);
  options.workers = workers;
  options.play = [lead](const game::GameConfiguration& game) { return game_with(lead, game); };
  return run_experiment(scenario, options);
}

// In lines that are long enough for every sentence.
std::string table_of(const ExperimentReport& report) {
  constexpr std::size_t kWide = 1000;
  return io::text_of(report.results.table, kWide);
}

std::string table_after(double lead, int max_pairs = 40) {
  const TemporaryFolder folder;
  const ExperimentReport report = played(small_comparison(max_pairs), folder.path(), lead);
  EXPECT_TRUE(report.is_complete);
  return table_of(report);
}

TEST(ComparisonSchedule, PlaysHeadToHeadWithoutOpponents) {
  const std::vector<ScheduledGame> games = small_comparison(3).experiment().games();
  ASSERT_EQ(games.size(), 6U);
  EXPECT_EQ(games[0].id, "new~old-p0001-1");
  EXPECT_EQ(games[5].id, "new~old-p0003-2");
}

TEST(ComparisonSchedule, PlaysOpponentsWithTheSameSeeds) {
  std::map<std::string, std::vector<std::uint64_t>> seeds;
  for (const ScheduledGame& game : comparison_against({4, 3}, 2).experiment().games())
    seeds[game.team_a + "~" + game.team_b].push_back(game.settings.combined().seed);
  ASSERT_EQ(seeds.size(), 5U);
  for (const char* matchup : {"new~old", "new~team0", "new~team1", "old~team0", "old~team1"})
    EXPECT_EQ(seeds[matchup], seeds["new~old"]) << matchup;
}

// Otherwise the differences of a pair number could not be compared before the last game.
TEST(ComparisonSchedule, PlaysAllMatchupsOfAPairNumberBeforeTheNext) {
  const std::vector<ScheduledGame> games = comparison_against({4}, 3).experiment().games();
  for (std::size_t i = 0; i < games.size(); ++i)
    EXPECT_EQ(games[i].pair, static_cast<int>(i) / 6 + 1);
}

TEST(ComparisonRun, SaysThatTheNewTeamIsBetterOrWorse) {
  EXPECT_TRUE(table_after(3).starts_with("new is better than old: +")) << table_after(3);
  EXPECT_TRUE(table_after(-3).starts_with("new is worse than old: -")) << table_after(-3);
}

TEST(ComparisonRun, SaysThatNoDifferenceMatters) {
  Scenario scenario = small_comparison(400);
  scenario.as<Comparison>()->test.least = 1;
  const TemporaryFolder folder;
  const ExperimentReport report = played(scenario, folder.path(), 0);
  EXPECT_EQ(report.results.comparison->verdict, ThreeWayVerdict::kNotShown);
  EXPECT_NE(table_of(report).find("new and old differ by less than 1 goals per game: "),
            std::string::npos);
  EXPECT_LT(report.games, 800);
}

TEST(ComparisonRun, EndsUndecidedAndSaysHowManyGamesWouldDo) {
  const std::string table = table_after(0, 20);
  EXPECT_TRUE(table.starts_with("undecided after 40 games whether new is better than old: "))
      << table;
  EXPECT_NE(table.find("games would decide"), std::string::npos) << table;
  EXPECT_NE(table_after(0, 3).find("too few games for an interval"), std::string::npos);
}

TEST(ComparisonRun, EndsWithThePairThatDecidesItForAnyNumberOfWorkers) {
  std::string first;
  for (const int workers : {1, 3}) {
    const TemporaryFolder folder;
    const ExperimentReport report = played(small_comparison(400), folder.path(), 3, workers);
    EXPECT_LT(report.games, 60);
    EXPECT_EQ(report.results.comparison->verdict, ThreeWayVerdict::kBetter);
    const std::string results = results_in(folder) + content_of(folder / "comparison.csv");
    if (first.empty()) first = results;
    EXPECT_EQ(results, first);
  }
}

TEST(ComparisonRun, TestsTheMeanOverAllOpponents) {
  const TemporaryFolder folder;
  const ExperimentReport report =
      run_experiment(comparison_against({4}, 12), fake_options(folder.path()));
  const io::Json& json = (*report.results.json)["comparison"];
  ASSERT_EQ(json["opponents"].size(), 2U);
  // Against the opponent, both teams' fake games have equal scores, since their seeds are equal.
  EXPECT_EQ(json["opponents"][1]["mean_diff"], 0);
  EXPECT_DOUBLE_EQ(json["mean_diff"].get<double>(),
                   json["opponents"][0]["mean_diff"].get<double>() / 2);
}

TEST(ComparisonRun, NoticesThatAChangeHasNoEffect) {
  const Scenario scenario = comparison_against({4}, 12);
  const TemporaryFolder folder;
  const std::string note = "22 are the same as old's in every frame";
  EXPECT_NE(table_of(run_experiment(scenario, fake_options(folder.path()))).find(note),
            std::string::npos);
  ExperimentOptions options = fake_options(folder / "other");
  options.play = [](const game::GameConfiguration& game) {
    game::GameRecord record = fake_game(game);
    record.state_hash += game.a.robots.size();
    return record;
  };
  EXPECT_EQ(table_of(run_experiment(scenario, options)).find("in every frame"), std::string::npos);
}

TEST(ComparisonRun, LeavesPairNumbersWithAVoidGameOut) {
  const std::uint64_t void_seed =
      small_comparison().experiment().games()[3].settings.combined().seed;
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = [void_seed](const game::GameConfiguration& game) -> game::GameRecord {
    if (game.seed == void_seed) throw std::runtime_error("no");
    return game_with(3, game);
  };
  const ExperimentReport report = run_experiment(small_comparison(), options);
  EXPECT_TRUE(report.is_complete);
  const io::Json& json = (*report.results.json)["comparison"];
  EXPECT_EQ(json["void_pairs"], 1);
  EXPECT_EQ(json["pairs"].get<int>() + 1, report.games / 2);
  EXPECT_EQ(json["opponents"][0]["games"], 2 * json["pairs"].get<int>());
  // Goals and difference are those of the same games, without the good leg of the void pair.
  EXPECT_NEAR(json["opponents"][0]["goals_of_new"].get<double>() -
                  json["opponents"][0]["goals_against_new"].get<double>(),
              json["mean_diff"].get<double>(), 1e-9);
  EXPECT_NE(table_of(report).find("Pairs left out because of a void game: 1."), std::string::npos);
}

// The games of pair numbers up to `void_pairs` are void.
ExperimentReport played_with_void_pairs(int void_pairs, const Scenario& scenario,
                                        const fs::path& folder) {
  std::set<std::uint64_t> void_seeds;
  for (const ScheduledGame& game : scenario.experiment().games())
    if (game.pair <= void_pairs) void_seeds.insert(game.settings.combined().seed);
  ExperimentOptions options = fake_options(folder);
  options.play = [&void_seeds](const game::GameConfiguration& game) -> game::GameRecord {
    if (void_seeds.contains(game.seed)) throw std::runtime_error("no");
    return game_with(3, game);
  };
  return run_experiment(scenario, options);
}

TEST(ComparisonRun, EndsIfAllOfTheFirstPairsAreVoid) {
  for (const auto& scenario : {small_comparison(), comparison_against({4})}) {
    const TemporaryFolder folder;
    const ExperimentReport report = played_with_void_pairs(12, scenario, folder.path());
    const std::size_t matchups = matchups_of(scenario.get<Comparison>()).size();
    EXPECT_TRUE(report.is_complete);
    EXPECT_EQ(report.games, 2 * 10 * static_cast<int>(matchups));
    EXPECT_EQ(report.void_games, report.games);
    EXPECT_EQ(report.results.comparison->sentence,
              "undecided: ended after 10 pairs, each with a void game");
  }
}

TEST(ComparisonRun, GoesOnIfOneOfTheFirstPairsIsNotVoid) {
  const TemporaryFolder folder;
  const ExperimentReport report = played_with_void_pairs(9, small_comparison(), folder.path());
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.results.comparison->verdict, ThreeWayVerdict::kBetter);
  EXPECT_EQ(report.void_games, 18);
}

TEST(ComparisonRun, ContinuesAfterAnInterruptAndWithMorePairs) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = interrupting();
  EXPECT_TRUE(run_experiment(small_comparison(8), options).is_interrupted);
  run_experiment(small_comparison(8), fake_options(folder.path()));
  run_experiment(small_comparison(40), fake_options(folder.path()));
  EXPECT_EQ(results_in(folder), undisturbed_results(small_comparison(40)));
}

TEST(ComparisonState, StopsAtTheFirstMissingGame) {
  const Scenario scenario = comparison_against({4});
  RowsById rows;
  for (const ScheduledGame& game : scenario.experiment().games()) {
    if (game.id == "old~team0-p0005-2") continue;
    GameRow row = row_of(game);
    row.record = fake_game(game::resolved(game.settings.combined()));
    rows[game.id] = row;
  }
  const ComparedTeams compared = compared_teams(*scenario.as<Comparison>(), rows);
  EXPECT_EQ(compared.last_pair, 4);
  EXPECT_EQ(compared.test.pairs, 4);
  EXPECT_FALSE(compared.is_decided);
  EXPECT_TRUE(answer(*scenario.as<Comparison>(), compared).starts_with("not decided yet after "));
}

TEST(ComparisonState, IsUndecidedBeforeTheFirstGame) {
  const Scenario scenario = small_comparison();
  const ComparedTeams compared = compared_teams(*scenario.as<Comparison>(), {});
  EXPECT_FALSE(compared.is_decided);
  EXPECT_EQ(answer(*scenario.as<Comparison>(), compared), "not decided yet");
}

const std::string kComparisonTop = "schema: 1\nkind: compare\nseed: 7\n";
const std::string kComparedTeams = "teams: { old: {}, new: { strategy: cobalt } }\n";

TEST(ReadComparison, NeedsNothingButTheTwoTeams) {
  const Comparison comparison =
      *read_scenario_text(kComparisonTop + kComparedTeams, "x.yaml").as<Comparison>();
  EXPECT_TRUE(comparison.against.empty());
  EXPECT_EQ(comparison.test.least, 0.3);
  EXPECT_EQ(comparison.test.max_pairs, 300);
}

TEST(ReadComparison, ReadsItsEffectiveScenarioBack) {
  for (const Scenario& scenario : {small_comparison(), comparison_against({4, 3})}) {
    const std::string text = effective_text(scenario);
    EXPECT_EQ(effective_text(read_scenario_text(text, "x.yaml")), text);
  }
}

class WrongComparison : public testing::TestWithParam<Mistake> {};

TEST_P(WrongComparison, IsRefusedWithItsLocationAndARemedy) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongComparison,
    testing::Values(Mistake{"OneTeam",
                            kComparisonTop + "teams: { old: {} }\n",
                            "x.yaml:4:1: teams: ",
                            {"expected 2 teams", "found 1"}},
                    Mistake{"OtherNames",
                            kComparisonTop + "teams: { old: {}, better: {} }\n",
                            "x.yaml:4:1: teams: ",
                            {"the team 'new' is missing"}},
                    Mistake{"OpponentWithATakenName",
                            kComparisonTop + kComparedTeams + "against: { old: {} }\n",
                            "x.yaml:5:12: against.old: ",
                            {"are taken", "rename"}},
                    Mistake{"NoLeastDifference",
                            kComparisonTop + kComparedTeams + "test: { least: 0 }\n",
                            "x.yaml:5:16: test.least: ",
                            {"above 0", "found '0'"}},
                    Mistake{"UnknownKeyOfTheTest",
                            kComparisonTop + kComparedTeams + "test: { min_pairs: 5 }\n",
                            "x.yaml:5:9: test: ",
                            {"'min_pairs'"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
