// kill -9 of a whole run ends its workers too. hundred_kills_test.cpp tests the results.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

using std::chrono::milliseconds;

ExperimentOptions slow_options(const std::filesystem::path& folder) {
  ExperimentOptions options = fake_options(folder);
  options.workers = 2;
  options.play = slow_fake_game;
  options.patience_s = 10;
  return options;
}

int result_rows_in(const std::filesystem::path& path) {
  std::ifstream file(path);
  int lines = 0;
  for (std::string line; std::getline(file, line);) ++lines;
  return lines;
}

// Looks at a condition every 10 ms until it holds, for a minute at most.
void wait_until(const std::function<bool()>& holds) {
  for (int i = 0; i < 6000 && !holds(); ++i) std::this_thread::sleep_for(milliseconds(10));
}

// Runs the experiment in a process and kills the process once `pids` has two lines.
void run_and_kill(const ExperimentOptions& options, const std::filesystem::path& pids) {
  const pid_t child = fork();
  if (child == 0) {
    run_experiment(small_sweep(20), options);
    _exit(0);
  }
  wait_until([&] { return result_rows_in(pids) >= 2; });
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

// Whether the process exists and is not a zombie.
bool is_running(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/stat");
  std::string number, name, state;
  return static_cast<bool>(file >> number >> name >> state) && state != "Z" && state != "X";
}

TEST(KilledRun, EndsItsWorkers) {
  const TemporaryFolder folder;
  ExperimentOptions options = slow_options(folder / "run");
  options.play = [&folder](const game::GameConfiguration& game) {
    write_content(folder / "pids", std::to_string(getpid()) + "\n", std::ios::app);
    std::this_thread::sleep_for(std::chrono::hours(1));
    return fake_game(game);
  };
  run_and_kill(options, folder / "pids");
  std::ifstream pids(folder / "pids");
  int workers = 0;
  for (std::string pid; std::getline(pids, pid); ++workers) {
    wait_until([&] { return !is_running(pid); });
    EXPECT_FALSE(is_running(pid)) << pid;
  }
  EXPECT_EQ(workers, 2);
}

}  // namespace
}  // namespace autoref::experiments
