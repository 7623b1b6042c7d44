// How much a folder with many games takes up while it is read.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/results/shard.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/files.hpp"
#include "referee/machine/machine.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

constexpr int kTeams = 30;  // 870 games with one pair per matchup, 17,400 with kManyPairs
constexpr int kManyPairs = 20;

// With as many transitions as a long game.
GameRow long_row(const ScheduledGame& game) {
  GameRow row = row_of(game);
  row.record = fake_game(resolved(game));
  bool is_taken = false;
  for (const std::string_view label : referee::all_labels()) {
    if ((is_taken = !is_taken)) row.record.transitions.push_back(label);
  }
  row.circumstances = {
      "1.0.0-0123456789", "a.host.with.a.long.name", "GenuineIntel 6/106", 1.2, 1, "0/1"};
  return row;
}

std::size_t fill(const std::filesystem::path& folder, int pairs) {
  const Scenario scenario = small_roundrobin(std::vector<int>(kTeams, 6), pairs);
  io::create_folder(folder / kGamesFolder);
  std::ofstream(folder / kEffectiveFile) << effective_text(scenario);
  std::ofstream rows(folder / kGamesFolder / ShardIndex{}.file_name());
  const RowFormat format = row_format(scenario.experiment());
  rows << io::csv_line(format.names()) << '\n';
  const std::vector<ScheduledGame> games = scenario.experiment().games();
  for (const ScheduledGame& game : games) rows << format.line(long_row(game)) << '\n';
  return games.size();
}

// The most memory that this process has had so far.
double most_bytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return 1024.0 * static_cast<double>(used.ru_maxrss);
}

// What `work` adds to the most memory of a process of its own.
template <typename Work>
double bytes_needed(Work work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    const double before = most_bytes();
    work();
    const double needed = most_bytes() - before;
    _exit(write(ends[1], &needed, sizeof needed) == sizeof needed ? 0 : 1);
  }
  double needed = -1;
  const bool is_known = read(ends[0], &needed, sizeof needed) == sizeof needed;
  close(ends[0]);
  close(ends[1]);
  waitpid(child, nullptr, 0);
  return is_known ? needed : -1;
}

// A process of its own begins without the pages of the program's code, so that only the difference
// between much and little work is that of the games.
double bytes_for_rows(int pairs, std::size_t& games) {
  const TemporaryFolder folder;
  games = fill(folder.path(), pairs);
  return bytes_needed([&folder] {
    const ResultFolder opened = open_results(folder.path());
    opened.scenario.experiment().results(opened.completed_games.done);
  });
}

double bytes_for_schedule(int teams, std::size_t& games) {
  const Scenario scenario = small_roundrobin(std::vector<int>(teams, 6), 1);
  games = scenario.experiment().games().size();
  return bytes_needed([&scenario] { scenario.experiment().games(); });
}

// `status` of 100,000 games needs less than 300 MB.
TEST(LargeFolder, NeedsAtMostThreeKilobytesForEachPlayedGame) {
  std::size_t few = 0;
  std::size_t many = 0;
  const double for_few = bytes_for_rows(1, few);
  const double for_many = bytes_for_rows(kManyPairs, many);
  ASSERT_GT(for_few, 0);
  EXPECT_LT((for_many - for_few) / static_cast<double>(many - few), AUTOREF_BYTES_PER_ROW);
}

TEST(LargeFolder, NeedsAKilobyteForEachScheduledGameHoweverManyTeamsThereAre) {
  std::size_t few = 0;
  std::size_t many = 0;
  const double for_few = bytes_for_schedule(10, few);
  const double for_many = bytes_for_schedule(150, many);
  ASSERT_GT(for_few, 0);
  EXPECT_LT((for_many - for_few) / static_cast<double>(many - few), AUTOREF_BYTES_PER_GAME);
}

}  // namespace
}  // namespace autoref::experiments
