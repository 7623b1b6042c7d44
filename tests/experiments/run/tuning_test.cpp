// Tunings with fake games: the same path for every number of workers and shards, and after kills.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <set>
#include <thread>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_tuning.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

ExperimentOptions tuning_options(const fs::path& folder) {
  ExperimentOptions options = fake_options(folder);
  options.play = fake_tuned_game;
  options.patience_s = 10;
  return options;
}

ExperimentReport tune(const fs::path& folder, const Scenario& scenario) {
  return run_experiment(scenario, tuning_options(folder));
}

std::string tuning_results_in(const fs::path& folder) {
  std::string text;
  for (const char* file : {"tune.csv", "summary.csv", "result.yaml", "results.csv"})
    text += content_of(folder / file);
  return text;
}

class TunedFolder : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { ASSERT_TRUE(tune(whole_.path(), scenario_).is_complete); }

  Scenario scenario_ = small_tuning(GetParam());
  TemporaryFolder whole_;
  TemporaryFolder folder_;
};

TEST_P(TunedFolder, IsTheSameForEveryNumberOfWorkers) {
  ExperimentOptions options = tuning_options(folder_.path());
  options.workers = 3;
  EXPECT_TRUE(run_experiment(scenario_, options).is_complete);
  EXPECT_EQ(tuning_results_in(folder_.path()), tuning_results_in(whole_.path()));
}

// Lines of the only shard; 0 before it is created.
int lines_in(const fs::path& folder) {
  return fs::exists(shard_of(folder)) ? line_count(content_of(shard_of(folder))) : 0;
}

// Kills the run once it has written a row, or ended, and some time more has passed.
void kill_after_a_row(pid_t child, const fs::path& folder, std::chrono::milliseconds more) {
  constexpr int kMostLooks = 20000;  // about 20 s
  const int before = std::max(1, lines_in(folder));
  for (int look = 0; look < kMostLooks && lines_in(folder) <= before; ++look) {
    if (waitpid(child, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(more);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

TEST_P(TunedFolder, IsTheSameAfterKillsAtAnyTime) {
  for (int kill_number = 0; kill_number < 8; ++kill_number) {
    const pid_t child = fork();
    if (child == 0) {
      ExperimentOptions options = tuning_options(folder_.path());
      options.workers = 2;
      options.play = [](const game::GameConfiguration& game) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return fake_tuned_game(game);
      };
      run_experiment(scenario_, options);
      _exit(0);
    }
    kill_after_a_row(child, folder_.path(), std::chrono::milliseconds(7 * (kill_number % 5)));
  }
  EXPECT_GT(line_count(content_of(shard_of(folder_.path()))), 1);
  EXPECT_TRUE(tune(folder_.path(), scenario_).is_complete);
  EXPECT_EQ(tuning_results_in(folder_.path()), tuning_results_in(whole_.path()));
}

// Each shard waits for the other after every iteration.
TEST_P(TunedFolder, IsTheSameForTwoShardsThatWaitForEachOther) {
  ExperimentOptions options = tuning_options(folder_.path());
  options.wait_s = 60;
  options.shard = {1, 2};
  const pid_t child = fork();
  if (child == 0) _exit(run_experiment(scenario_, options).played > 0 ? 0 : 1);
  options.shard = {0, 2};
  const ExperimentReport report = run_experiment(scenario_, options);
  int status = 1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_GT(report.played, 0);
  const ResultFolder folder = open_results(folder_.path());
  EXPECT_TRUE(folder.is_complete());
  write_results(folder.path, folder.scenario, folder.format, folder.completed_games.done);
  EXPECT_EQ(tuning_results_in(folder_.path()), tuning_results_in(whole_.path()));
}

INSTANTIATE_TEST_SUITE_P(Of, TunedFolder, testing::Values("spsa", "self", "cma_es"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Tuning, FindsABetterTeamAndSaysSo) {
  const TemporaryFolder folder;
  const ExperimentReport report = tune(folder.path(), small_tuning("spsa"));
  ASSERT_TRUE(report.results.search);
  EXPECT_EQ((*report.results.json)["tuning"]["verdict"], "better");
  EXPECT_NE(io::text_of(report.results.table).find("The result is better than the start"),
            std::string::npos)
      << io::text_of(report.results.table);
  EXPECT_NEAR(report.results.search->parameters.front().best.back(), kBestRisk, 0.2);
}

TEST(Tuning, DoesNotCallAnEqualTeamBetter) {
  Scenario scenario = small_tuning("spsa");
  Tuning& tuning = *scenario.as<Tuning>();
  tuning.parameters.front().start = kBestRisk;  // nothing is left to improve
  const TemporaryFolder folder;
  const ExperimentReport report = tune(folder.path(), scenario);
  EXPECT_NE(io::text_of(report.results.table).find("not shown to be better"), std::string::npos)
      << io::text_of(report.results.table);
}

// The test's games must not be those that the search has seen.
TEST(Tuning, TestsWithSeedsOfItsOwn) {
  const std::vector<ScheduledGame> games = small_tuning("spsa").experiment().games();
  std::set<std::uint64_t> searched;
  std::set<std::uint64_t> tested;
  for (const ScheduledGame& game : games)
    (game.id.starts_with("test-") ? tested : searched).insert(game.settings.leg().seed);
  ASSERT_FALSE(tested.empty());
  for (const std::uint64_t seed : tested) EXPECT_FALSE(searched.contains(seed));
}

TEST(Tuning, PlaysAllCandidatesOfAnIterationWithTheSameSeeds) {
  std::map<std::string, std::set<std::uint64_t>> seeds;  // by candidate
  for (const ScheduledGame& game : small_tuning("cma_es").experiment().games()) {
    if (game.id.starts_with("k0002-")) seeds[game.team_a].insert(game.settings.leg().seed);
  }
  ASSERT_GT(seeds.size(), 2U);
  for (const auto& [candidate, its] : seeds) EXPECT_EQ(its, seeds.begin()->second) << candidate;
}

TEST(Tuning, WaitsInVainForAShardThatDoesNotPlay) {
  const TemporaryFolder folder;
  ExperimentOptions options = tuning_options(folder.path());
  options.shard = {0, 2};
  options.wait_s = 0.1;
  const ExperimentReport report = run_experiment(small_tuning("spsa"), options);
  EXPECT_TRUE(report.is_waiting);
  EXPECT_FALSE(report.is_complete);
}

// A killed game's row must not become part of the path, since the game will be replayed.
TEST(Tuning, StopsBehindAKilledGameAndThenGoesOnTheSamePath) {
  const Scenario scenario = small_tuning("spsa");
  const TemporaryFolder whole;
  tune(whole.path(), scenario);
  const TemporaryFolder folder;
  ExperimentOptions options = tuning_options(folder.path());
  const std::string victim = "k0003-plus~other-p0001-2";
  options.play = [&victim](const game::GameConfiguration& game) {
    if (game.id == victim) kill(getpid(), SIGKILL);
    return fake_tuned_game(game);
  };
  const ExperimentReport report = run_experiment(scenario, options);
  EXPECT_EQ(report.killed_games, 1);
  EXPECT_TRUE(report.is_waiting);
  EXPECT_TRUE(tune(folder.path(), scenario).is_complete);
  EXPECT_EQ(tuning_results_in(folder.path()), tuning_results_in(whole.path()));
}

TEST(Tuning, RefusesAFolderOfAnotherSearch) {
  const TemporaryFolder folder;
  Scenario scenario = small_tuning("spsa");
  tune(folder.path(), scenario);
  scenario.as<Tuning>()->gain = 0.5;
  try {
    tune(folder.path(), scenario);
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gain is 0.5 here and 0.3 there"), std::string::npos)
        << error.what();
  }
}

TEST(Tuning, ResultCanBePastedIntoAScenario) {
  const TemporaryFolder folder;
  tune(folder.path(), small_tuning("spsa"));
  std::string teams = content_of(folder / "result.yaml");
  teams.replace(teams.find("\ntuned:") + 1, 0, "  ");
  teams.insert(teams.find("\n  strategy") + 1, "  ");
  teams.insert(teams.find("\n  params") + 1, "  ");
  const Scenario robin = read_scenario_text(
      "schema: 1\nkind: roundrobin\npairs: 1\nseed: 1\nteams:\n  zone: {}\n" + teams, "x.yaml");
  const game::TeamSettings& tuned = robin.as<RoundRobin>()->teams.at("tuned");
  EXPECT_EQ(tuned.strategy, "cobalt");
  EXPECT_NEAR(tuned.params.at("pass_risk"), kBestRisk, 0.2);
}

}  // namespace
}  // namespace autoref::experiments
