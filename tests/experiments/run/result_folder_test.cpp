#include "experiments/run/result_folder.hpp"

#include <gtest/gtest.h>

#include "experiments/results/shard.hpp"
#include "experiments/run/verification.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

// A folder with all 12 games of a small sweep.
struct Filled {
  Filled() { run_experiment(small_sweep(), fake_options(folder.path())); }
  TemporaryFolder folder;
};

// The error message when opening the folder; empty if there is none.
std::string refusal(const std::filesystem::path& folder, const std::string& build = {}) {
  try {
    open_results(folder, build);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ResultFolder, HasTheScheduledGames) {
  const Filled filled;
  const ResultFolder folder = open_results(filled.folder.path());
  EXPECT_EQ(folder.games.size(), 12U);
  EXPECT_EQ(folder.build, "0.1.0-test");
  EXPECT_TRUE(folder.is_complete());
  EXPECT_EQ(folder.by_shard, (std::map<std::string, int>{{"0/1", 12}}));
}

TEST(ResultFolder, CanBeReadBeforeItIsComplete) {
  const Filled filled;
  const std::string rows = content_of(shard_of(filled.folder.path()));
  write_content(shard_of(filled.folder.path()), rows.substr(0, rows.size() * 2 / 3));
  const ResultFolder folder = open_results(filled.folder.path());
  EXPECT_FALSE(folder.is_complete());
  EXPECT_GT(folder.completed_games.done.size(), 4U);
  EXPECT_TRUE(folder.damaged.empty());
}

TEST(ResultFolder, IsRewrittenIdentically) {
  const Filled filled;
  const std::string before = content_of(filled.folder / "results.csv");
  const ResultFolder folder = open_results(filled.folder.path());
  std::filesystem::remove(filled.folder / "results.csv");
  write_results(folder.path, folder.scenario, folder.format, folder.completed_games.done);
  EXPECT_EQ(content_of(filled.folder / "results.csv"), before);
}

TEST(ResultFolder, DoesNotOverwriteFilesOfOthers) {
  for (const char* name : {"results.csv", "effective.yaml"}) {
    const TemporaryFolder folder;
    write_content(folder / name, "mine");
    try {
      run_experiment(small_sweep(), fake_options(folder.path()));
      ADD_FAILURE() << "no error";
    } catch (const io::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(std::string("has ") + name + ", but no"),
                std::string::npos)
          << error.what();
    }
    EXPECT_EQ(content_of(folder / name), "mine");
    EXPECT_FALSE(std::filesystem::exists(folder / "games"));
  }
}

TEST(ResultFolder, RefusesAFolderWithoutResults) {
  const TemporaryFolder folder;
  EXPECT_NE(refusal(folder.path()).find("holds no results: expected effective.yaml"),
            std::string::npos);
}

TEST(ResultFolder, RequiresAChoiceBetweenSeveralBuilds) {
  const Filled filled;
  ExperimentOptions options = fake_options(filled.folder.path());
  options.build = "0.1.0-other";
  options.allow_mixed_build = true;
  run_experiment(small_sweep(1), options);
  EXPECT_NE(refusal(filled.folder.path()).find("0.1.0-other, 0.1.0-test; choose one"),
            std::string::npos);
  EXPECT_NE(refusal(filled.folder.path(), "0.2").find("has no games of 0.2"), std::string::npos);
  EXPECT_EQ(open_results(filled.folder.path(), "0.1.0-other").completed_games.done.size(), 4U);
}

void play_fake_game(const game::GameConfiguration& game, GameRow& row) {
  row.record = fake_game(game);
}

TEST(Verify, FindsNoDifferenceIfGamesEndAsBefore) {
  const Filled filled;
  const Verification verification =
      verify(open_results(filled.folder.path()), 5, 2, play_fake_game, nullptr);
  EXPECT_EQ(verification.played, 5);
  EXPECT_TRUE(verification.differences.empty());
}

TEST(Verify, ReportsTheColumnThatDiffers) {
  const Filled filled;
  const auto other_game = [](const game::GameConfiguration& game, GameRow& row) {
    play_fake_game(game, row);
    row.record.state_hash += game.b.robots.size() == 5 ? 1U : 0U;
  };
  const Verification verification =
      verify(open_results(filled.folder.path()), 100, 2, other_game, nullptr);
  EXPECT_EQ(verification.played, 12);
  ASSERT_EQ(verification.differences.size(), 6U);
  EXPECT_EQ(verification.differences.front().column.column, "state_hash");
}

TEST(Verify, ThrowsIfAllGamesAreVoid) {
  const TemporaryFolder folder;
  ExperimentOptions options = fake_options(folder.path());
  options.play = [](const game::GameConfiguration&) -> game::GameRecord {
    throw std::runtime_error("no");
  };
  run_experiment(small_sweep(), options);
  EXPECT_THROW(verify(open_results(folder.path()), 5, 1, play_fake_game, nullptr), io::InputError);
}

}  // namespace
}  // namespace autoref::experiments
