// Games that crash, throw, or whose workers are killed.
#include "experiments/run/run_experiment.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <thread>

#include "experiments/results/shard.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

TEST(Experiment, RetriesTheGameOfAKilledWorker) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = [&folder](const game::GameConfiguration& game) {
    const std::filesystem::path mark = folder / std::to_string(game.seed);
    if (!std::filesystem::exists(mark)) {
      write_content(mark, "");
      kill(getpid(), SIGKILL);
    }
    return fake_game(game);
  };
  EXPECT_EQ(run_experiment(small_sweep(), options).void_games, 0);
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep()));
}

TEST(Experiment, MarksAGameThatCrashesEveryWorkerVoidAndContinues) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = [](const game::GameConfiguration& game) {
    if (game.b.robots.size() == 5 && game.match.a_plays == Side::kEast) std::abort();
    return fake_game(game);
  };
  const ExperimentReport report = run_experiment(small_sweep(), options);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.void_games, 3);
  EXPECT_EQ(report.results.groups.at(1).void_games, 3);
  EXPECT_EQ(report.results.groups.at(1).goals_a.size(), 3U);
  EXPECT_NE(content_of(folder / "results.csv").find("signal 6 (Aborted)"), std::string::npos);
}

// Both a worker and the programs may be ended by somebody else.
TEST(Experiment, CountsTheAttemptsOfAGameInItsRow) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder / "run");
  options.play = [&folder](const game::GameConfiguration& game) {
    if (game.b.robots.size() == 5 && std::filesystem::create_directory(folder / "killed"))
      kill(getpid(), SIGKILL);
    game::GameRecord record = fake_game(game);
    record.attempts = game.b.robots.size() == 5 ? 3 : 1;
    return record;
  };
  run_experiment(small_sweep(1), options);
  std::multiset<int> attempts;
  const Scenario scenario = small_sweep(1);
  const StoredRows stored = read_rows(folder / "run/games", row_format(scenario.experiment()));
  for (const auto& [id, row] : stored.rows) attempts.insert(row.circumstances.attempt);
  EXPECT_EQ(attempts, (std::multiset<int>{1, 1, 3, 4}));
}

// A game whose worker is killed, as by the out-of-memory killer.
game::GameRecord killed_game(const game::GameConfiguration& game) {
  if (game.b.robots.size() == 5 && game.match.a_plays == Side::kEast) kill(getpid(), SIGKILL);
  return fake_game(game);
}

TEST(Experiment, ReplaysKilledGamesInTheNextRun) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = killed_game;
  const ExperimentReport killed = run_experiment(small_sweep(), options);
  EXPECT_EQ(killed.void_games, 3);
  EXPECT_EQ(killed.killed_games, 3);
  const ExperimentReport report = run_experiment(small_sweep(), fake_options(folder.path()));
  EXPECT_EQ(report.played, 3);
  EXPECT_EQ(report.void_games, 0);
  EXPECT_EQ(results_in(folder), undisturbed_results(small_sweep()));
  EXPECT_EQ(run_experiment(small_sweep(), fake_options(folder.path())).played, 0);
}

TEST(Experiment, ReplaysKilledGamesOncePerRun) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = killed_game;
  run_experiment(small_sweep(), options);
  const ExperimentReport report = run_experiment(small_sweep(), options);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 3);
  EXPECT_EQ(report.killed_games, 3);
}

TEST(Experiment, ReportsThatItReplaysKilledGames) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = killed_game;
  run_experiment(small_sweep(), options);
  options = fake_options(folder.path());
  options.progress = stderr;
  testing::internal::CaptureStderr();
  run_experiment(small_sweep(), options);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("3 games are void because their workers were killed; they will be replayed"),
            std::string::npos)
      << said;
}

TEST(Experiment, DoesNotReplayGamesThatFailByThemselves) {
  for (const auto& play :
       std::vector<std::function<game::GameRecord(const game::GameConfiguration&)>>{
           [](const game::GameConfiguration&) -> game::GameRecord { std::abort(); },
           [](const game::GameConfiguration&) -> game::GameRecord {
             throw std::runtime_error("no");
           },
           [](const game::GameConfiguration& game) {
             std::this_thread::sleep_for(std::chrono::seconds(60));
             return fake_game(game);
           }}) {
    const TemporaryFolder folder;
    ExperimentOptions options = fake_options(folder.path());
    options.play = play;
    options.longest_game_s = 0.1;
    EXPECT_EQ(run_experiment(small_sweep(1), options).void_games, 4);
    const ExperimentReport report = run_experiment(small_sweep(1), fake_options(folder.path()));
    EXPECT_EQ(report.played, 0);
    EXPECT_EQ(report.void_games, 4);
  }
}

TEST(Experiment, MarksAGameThatThrowsVoid) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = [](const game::GameConfiguration&) -> game::GameRecord {
    throw std::runtime_error("oh, no");
  };
  EXPECT_EQ(run_experiment(small_sweep(1), options).void_games, 4);
  EXPECT_NE(content_of(folder / "results.csv").find(",void,void,\"the game threw: oh, no\","),
            std::string::npos);
}

}  // namespace
}  // namespace autoref::experiments
