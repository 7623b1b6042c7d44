// kill -9 of a whole run, at many moments: the next run completes it as if nothing had happened.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/runner/fake_games.hpp"

namespace autoref::runner {
namespace {

using std::chrono::milliseconds;

ExperimentOptions slow_options(const std::filesystem::path& folder) {
  ExperimentOptions options = fake_options(folder);
  options.workers = 2;
  options.play = slow_fake_game;
  options.patience_s = 10;
  return options;
}

// Runs the experiment in a process that is killed after `life`.
void run_and_kill(const ExperimentOptions& options, milliseconds life) {
  const pid_t child = fork();
  if (child == 0) {
    run_experiment(small_sweep(20), options);
    _exit(0);
  }
  std::this_thread::sleep_for(life);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

// Neither gone nor a zombie.
bool is_running(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/stat");
  std::string number, name, state;
  return static_cast<bool>(file >> number >> name >> state) && state != "Z" && state != "X";
}

TEST(KilledRun, IsCompletedByTheNextWithTheSameResults) {
  const TemporaryFolder calm;
  run_experiment(small_sweep(20), fake_options(calm.path()));
  const TemporaryFolder folder;
  for (const int life_ms : {1, 3, 7, 13, 20, 29, 33, 41}) {
    run_and_kill(slow_options(folder.path()), milliseconds(life_ms));
  }
  const ExperimentReport report = run_experiment(small_sweep(20), slow_options(folder.path()));
  EXPECT_TRUE(report.is_complete);
  EXPECT_LT(report.played, 80);  // the killed runs' rows are not lost
  EXPECT_EQ(content_of(folder / "results.csv"), content_of(calm / "results.csv"));
  EXPECT_EQ(content_of(folder / "summary.csv"), content_of(calm / "summary.csv"));
}

TEST(KilledRun, TakesItsWorkersAlong) {
  const TemporaryFolder folder;
  ExperimentOptions options = slow_options(folder / "run");
  options.play = [&folder](const GameConfiguration& game) {
    write_content(folder / "pids", std::to_string(getpid()) + "\n", std::ios::app);
    std::this_thread::sleep_for(std::chrono::seconds(60));
    return fake_game(game);
  };
  run_and_kill(options, milliseconds(300));
  std::ifstream pids(folder / "pids");
  int workers = 0;
  for (std::string pid; std::getline(pids, pid); ++workers) {
    for (int i = 0; i < 200 && is_running(pid); ++i) std::this_thread::sleep_for(milliseconds(10));
    EXPECT_FALSE(is_running(pid)) << pid;
  }
  EXPECT_EQ(workers, 2);
}

}  // namespace
}  // namespace autoref::runner
