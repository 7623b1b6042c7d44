// Runs while other programs change their folder, and while space, memory or descriptors run out.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <system_error>

#include "experiments/results/shard.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/run/run_experiment.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

struct Interference {
  const char* name;
  std::function<void(const fs::path& folder)> happens;
};

std::string name_of(const testing::TestParamInfo<Interference>& info) { return info.param.name; }

void replace_by(const fs::path& file, const std::string& content) {
  write_content(file.string() + ".new", content);
  fs::rename(file.string() + ".new", file);
}

std::string first_half_of(const std::string& text) {
  return text.substr(0, text.rfind('\n', text.size() / 2) + 1);
}

class DisturbedRun : public testing::TestWithParam<Interference> {};

// Disturbs a run when it starts its sixth game.
ExperimentReport disturbed_run(const fs::path& folder,
                               const std::function<void(const fs::path&)>& happens) {
  ExperimentOptions options = fake_options(folder);
  int started = 0;
  options.starting = [&](const ScheduledGame&) {
    if (++started == 6) happens(folder);
  };
  const ExperimentReport report = run_experiment(small_sweep(), options);
  EXPECT_GE(started, 6) << "nothing has disturbed the run";
  return report;
}

TEST_P(DisturbedRun, LosesNoRow) {
  const TemporaryFolder parent;
  const fs::path folder = parent / "run";
  const ExperimentReport report = disturbed_run(folder, GetParam().happens);
  EXPECT_TRUE(report.is_complete);
  const ResultFolder stored = open_results(folder);
  EXPECT_TRUE(stored.is_complete());
  EXPECT_EQ(results_csv(stored.format, stored.completed_games.done),
            content_of(folder / "results.csv"));
  EXPECT_EQ(line_count(content_of(folder / "results.csv")), 13);
}

TEST_P(DisturbedRun, HasEachRowOnce) {
  const TemporaryFolder parent;
  disturbed_run(parent / "run", GetParam().happens);
  EXPECT_EQ(line_count(content_of(shard_of(parent / "run"))), 13);
}

INSTANTIATE_TEST_SUITE_P(
    Each, DisturbedRun,
    testing::Values(
        Interference{"RowsReplacedByACopy",
                     [](const fs::path& folder) {
                       replace_by(shard_of(folder), content_of(shard_of(folder)));
                     }},
        Interference{"RowsReplacedByAnOlderCopy",
                     [](const fs::path& folder) {
                       replace_by(shard_of(folder), first_half_of(content_of(shard_of(folder))));
                     }},
        Interference{"RowsReplacedByAnEmptyFile",
                     [](const fs::path& folder) { replace_by(shard_of(folder), ""); }},
        Interference{"HeaderRemoved",
                     [](const fs::path& folder) {
                       const std::string rows = content_of(shard_of(folder));
                       replace_by(shard_of(folder), rows.substr(rows.find('\n') + 1));
                     }},
        Interference{"LineEndsChanged",
                     [](const fs::path& folder) {
                       std::string rows = content_of(shard_of(folder));
                       for (std::size_t at = 0; (at = rows.find('\n', at)) != std::string::npos;
                            at += 2)
                         rows.insert(at, "\r");
                       replace_by(shard_of(folder), rows);
                     }},
        Interference{"RowsRemoved", [](const fs::path& folder) { fs::remove(shard_of(folder)); }},
        Interference{"RowsRenamed",
                     [](const fs::path& folder) {
                       fs::rename(shard_of(folder), folder / "games/mine.bak");
                     }},
        Interference{"RowsShortenedInPlace",
                     [](const fs::path& folder) {
                       write_content(shard_of(folder), first_half_of(content_of(shard_of(folder))));
                     }},
        Interference{"GamesFolderRemoved",
                     [](const fs::path& folder) { fs::remove_all(folder / "games"); }},
        Interference{"FolderRemoved", [](const fs::path& folder) { fs::remove_all(folder); }},
        Interference{
            "FolderRenamed",
            [](const fs::path& folder) { fs::rename(folder, folder.string() + "-moved"); }}),
    name_of);

TEST(DisturbedRun, SaysThatItsRowsWereReplaced) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> messages(
      std::fopen((folder / "said").c_str(), "w"), std::fclose);
  options.progress = messages.get();
  options.starting = [&](const ScheduledGame&) { fs::remove(shard_of(folder.path())); };
  run_experiment(small_sweep(1), options);
  std::fflush(messages.get());
  EXPECT_NE(content_of(folder / "said")
                .find("shard-0-of-1.csv was replaced, moved, shortened or removed"),
            std::string::npos)
      << content_of(folder / "said");
}

// What a game throws if the machine has too little of something.
struct Shortage {
  const char* name;
  std::function<void()> strikes;
};

std::string name_of_shortage(const testing::TestParamInfo<Shortage>& info) {
  return info.param.name;
}

class ShortMachine : public testing::TestWithParam<Shortage> {};

// A sweep whose games fail for want of something from the third on.
ExperimentOptions short_options(const fs::path& folder, const std::function<void()>& strikes) {
  ExperimentOptions options = fake_options(folder);
  options.play = [strikes, played = 0](const game::GameConfiguration& game) mutable {
    if (++played > 2) strikes();
    return fake_game(game);
  };
  return options;
}

TEST_P(ShortMachine, StopsTheRunAndStoresNoResult) {
  const TemporaryFolder folder;
  EXPECT_THROW(run_experiment(small_sweep(), short_options(folder.path(), GetParam().strikes)),
               io::InputOutputError);
  const ResultFolder stored = open_results(folder.path());
  EXPECT_EQ(stored.completed_games.done.size(), 2U);
  EXPECT_EQ(stored.void_games(), 0);
}

TEST_P(ShortMachine, LetsTheRunGoOnAfterwards) {
  const TemporaryFolder folder;
  EXPECT_THROW(run_experiment(small_sweep(), short_options(folder.path(), GetParam().strikes)),
               io::InputOutputError);
  const ExperimentReport report = run_experiment(small_sweep(), fake_options(folder.path()));
  EXPECT_EQ(report.played, 10);
  EXPECT_EQ(report.void_games, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Each, ShortMachine,
    testing::Values(Shortage{"Descriptors",
                             [] { throw io::io_error("cannot open a pipe", EMFILE); }},
                    Shortage{"Space",
                             [] {
                               throw std::filesystem::filesystem_error(
                                   "cannot write",
                                   std::make_error_code(std::errc::no_space_on_device));
                             }},
                    Shortage{"Threads",
                             [] {
                               throw std::system_error(
                                   std::make_error_code(std::errc::resource_unavailable_try_again));
                             }},
                    Shortage{"Memory", [] { throw std::bad_alloc(); }}),
    name_of_shortage);

}  // namespace
}  // namespace autoref::experiments
