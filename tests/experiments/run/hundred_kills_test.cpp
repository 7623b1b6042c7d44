// Kills runs and their workers (kill -9) a hundred times at random moments of an experiment. The
// results must equal those of an undisturbed run.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <new>
#include <random>
#include <thread>
#include <vector>

#include "experiments/run/result_folder.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr int kKills = 100;
constexpr int kMostGamesBetweenKills = 4;
constexpr int kPairs = 110;  // two values make 440 games, more than can end between kills

// A semaphore shared by all processes, which counts the games that may still end. It ties the pace
// of the games to the pace of the kills, so the test does not depend on the machine's speed.
class Gate {
 public:
  Gate() {
    void* const page =
        mmap(nullptr, sizeof *games_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw std::bad_alloc();
    games_ = new (page) std::atomic<int>(0);
  }
  ~Gate() { munmap(games_, sizeof *games_); }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  void let_through(int games) { *games_ += games; }
  void pass() {
    while (*games_ <= 0) std::this_thread::sleep_for(milliseconds(1));
    --*games_;
  }

 private:
  std::atomic<int>* games_ = nullptr;
};

std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = content_of(entry.path() / "stat");  // "12 (a name) S 11 ..."
    const std::size_t end = stat.rfind(") ");
    if (end == std::string::npos || stat[end + 2] == 'Z') continue;
    if (std::stoi(stat.substr(end + 4)) == parent) children.push_back(std::stoi(name));
  }
  return children;
}

// One experiment played by several runs in the same folder.
class KilledRuns {
 public:
  KilledRuns(const fs::path& folder, int shards) : folder_(folder), runs_(shards) {
    for (int i = 0; i < shards; ++i) start(i);
  }
  ~KilledRuns() {
    for (const pid_t run : runs_) end(run);
  }
  KilledRuns(const KilledRuns&) = delete;
  KilledRuns& operator=(const KilledRuns&) = delete;

  Gate& gate() { return gate_; }
  int count() const { return static_cast<int>(runs_.size()); }

  // Restarts the run. Returns whether it was still running.
  bool kill_run(int i) {
    const bool was_running = WIFSIGNALED(end(runs_[i]));
    start(i);
    return was_running;
  }

  // Returns whether the run had a worker at that moment.
  bool kill_worker(int i, std::size_t chance) {
    const std::vector<pid_t> workers = children_of(runs_[i]);
    return !workers.empty() && kill(workers[chance % workers.size()], SIGKILL) == 0;
  }

  // Returns whether all runs exit with status 0 in time.
  bool end_well(std::chrono::seconds patience) {
    const auto until = std::chrono::steady_clock::now() + patience;
    for (pid_t& run : runs_) {
      int status = -1;
      while (waitpid(run, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::sleep_for(milliseconds(5));
      }
      run = -1;
      if (status != 0) return false;
    }
    return true;
  }

 private:
  void start(int i) {
    runs_[i] = fork();
    if (runs_[i] != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    ExperimentOptions options = fake_options(folder_);
    options.workers = count() == 1 ? 2 : 1;
    options.shard = {i, count()};
    options.patience_s = 20;
    options.attempts =
        1000;  // in a real run, three deaths of one game's workers mean that the game is at fault
    options.play = [this](const game::GameConfiguration& game) {
      gate_.pass();
      return fake_game(game);
    };
    run_experiment(small_sweep(kPairs), options);
    _exit(0);
  }

  static int end(pid_t run) {
    int status = 0;
    if (run <= 0) return status;
    kill(run, SIGKILL);
    waitpid(run, &status, 0);
    return status;
  }

  fs::path folder_;
  Gate gate_;
  std::vector<pid_t> runs_;
};

// Returns the number of kills that hit a process. The number of tries is limited.
int hundred_kills(KilledRuns& runs, unsigned seed) {
  std::mt19937 random(seed);
  int kills = 0;
  for (int tries = 0; kills < kKills && tries < 20 * kKills; ++tries) {
    std::this_thread::sleep_for(milliseconds(random() % 20));
    const int run = static_cast<int>(random() % static_cast<unsigned>(runs.count()));
    const bool has_hit = random() % 2 == 0 ? runs.kill_run(run) : runs.kill_worker(run, random());
    if (!has_hit) continue;
    ++kills;
    runs.gate().let_through(static_cast<int>(random() % (kMostGamesBetweenKills + 1)));
  }
  return kills;
}

int rows_in(const fs::path& folder) {
  int rows = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(folder / "games")) {
    rows += line_count(content_of(file.path())) - 1;
  }
  return rows;
}

std::vector<std::string> leftovers_in(const fs::path& folder) {
  std::vector<std::string> leftovers;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().string().find(".part") != std::string::npos) {
      leftovers.push_back(entry.path());
    }
  }
  return leftovers;
}

class HundredKills : public testing::TestWithParam<int> {};

TEST_P(HundredKills, LeaveTheResultsOfAnUndisturbedRun) {
  const TemporaryFolder calm;
  run_experiment(small_sweep(kPairs), fake_options(calm.path()));
  const TemporaryFolder folder;
  KilledRuns runs(folder.path(), GetParam());
  ASSERT_EQ(hundred_kills(runs, 2014), kKills);
  ASSERT_LT(rows_in(folder.path()), 4 * kPairs);  // otherwise, the last kills came too late
  runs.gate().let_through(1000 * kPairs);
  ASSERT_TRUE(runs.end_well(std::chrono::seconds(300)));
  EXPECT_EQ(rows_in(folder.path()), 4 * kPairs);
  const ResultFolder merged = open_results(folder.path());
  write_results(merged.path, merged.scenario, merged.format, merged.completed_games.done);
  EXPECT_EQ(content_of(folder / "results.csv"), content_of(calm / "results.csv"));
  EXPECT_TRUE(leftovers_in(folder.path()).empty());
}

INSTANTIATE_TEST_SUITE_P(Shards, HundredKills, testing::Values(1, 2, 5),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace autoref::experiments
