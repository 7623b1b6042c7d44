// An experiment divided among several runs.
#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

ExperimentReport run_shard(const fs::path& folder, int number, int of) {
  ExperimentOptions options = fake_options(folder);
  options.shard = {number, of};
  return run_experiment(small_sweep(), options);
}

std::string shard_results_in(const fs::path& folder) {
  return content_of(folder / "results.csv") + content_of(folder / "summary.csv");
}

class Shards : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { run_experiment(small_sweep(), fake_options(whole_.path())); }

  TemporaryFolder whole_;
  TemporaryFolder folder_;
};

TEST_P(Shards, WriteTheSameResultsInOneFolder) {
  for (int i = GetParam() - 1; i > 0; --i) {
    const ExperimentReport report = run_shard(folder_.path(), i, GetParam());
    EXPECT_FALSE(report.is_complete);
    EXPECT_FALSE(report.is_interrupted);
  }
  EXPECT_TRUE(run_shard(folder_.path(), 0, GetParam()).is_complete);
  EXPECT_EQ(shard_results_in(folder_.path()), shard_results_in(whole_.path()));
}

TEST_P(Shards, GiveTheSameResultsIfTheirRowsAreCopiedTogether) {
  for (int i = 0; i < GetParam(); ++i) {
    const TemporaryFolder own;
    run_shard(own.path(), i, GetParam());
    fs::copy(own.path(), folder_.path(),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  const ResultFolder folder = open_results(folder_.path());
  write_results(folder.path, folder.scenario, folder.format, folder.completed_games.done);
  EXPECT_EQ(shard_results_in(folder_.path()), shard_results_in(whole_.path()));
}

INSTANTIATE_TEST_SUITE_P(All, Shards, testing::Values(1, 2, 5));

TEST(ScheduledGames, AreOneUnitIfTheyAreLegsOfAPair) {
  for (const Scenario& scenario : {small_sweep(), small_roundrobin({6, 5, 4})}) {
    const std::vector<ScheduledGame> games = scenario.experiment().games();
    for (std::size_t i = 0; i < games.size(); ++i) EXPECT_EQ(games[i].unit, i / 2);
  }
}

TEST(ShardIndex, AssignsEveryUnitToOneShard) {
  for (std::size_t unit = 0; unit < 40; ++unit) {
    int shards = 0;
    for (int i = 0; i < 3; ++i) shards += ShardIndex{i, 3}.has(unit) ? 1 : 0;
    EXPECT_EQ(shards, 1);
  }
}

TEST(ShardIndex, GetsOneOfAsManyUnitsInARowAsThereAreShards) {
  for (std::size_t block = 0; block < 50; ++block) {
    int units = 0;
    for (std::size_t i = 0; i < 3; ++i) units += ShardIndex{1, 3}.has(3 * block + i, 6) ? 1 : 0;
    EXPECT_EQ(units, 1);
  }
}

TEST(ShardIndex, IsParsedFromItsName) {
  EXPECT_EQ(shard_index_of("3/12").number, 3);
  EXPECT_EQ(shard_index_of("3/12").of, 12);
  EXPECT_EQ(shard_index_of("3/12").name(), "3/12");
}

TEST(ShardIndex, RefusesOtherText) {
  for (const char* text : {"", "1", "1/", "/2", "2/2", "-1/2", "0/0", "1/2x", "0/10001", "a/b",
                           "99999999999/2", "0 /2"})
    EXPECT_THROW(shard_index_of(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace autoref::experiments
