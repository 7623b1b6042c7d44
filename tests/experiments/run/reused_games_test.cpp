// Comparisons that take over games of earlier ones.
#include "experiments/run/reused_games.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "tests/experiments/run/fake_games.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

constexpr int kReusedPairs = 3;

// The three games of a pair number and leg are new against old, new against zone, old against zone.
Scenario comparison_with_opponent() {
  Scenario scenario = small_comparison(kReusedPairs);
  scenario.as<Comparison>()->against["zone"].robots = 4;
  return scenario;
}

class ReusedGames : public testing::Test {
 protected:
  ExperimentReport play(const Scenario& scenario, const std::string& folder,
                        const std::string& reused = {}, const std::string& build = "0.1.0-test") {
    ExperimentOptions options = fake_options(parent_ / folder);
    options.build = build;
    if (!reused.empty()) options.reused_folder = parent_ / reused;
    return run_experiment(scenario, options);
  }
  std::string file(const std::string& folder, const std::string& name = kResultsFile) const {
    return content_of(parent_ / folder / name);
  }
  ReusableGames reusable(const Scenario& scenario, const std::string& folder) const {
    return reusable_games(parent_ / folder, scenario.experiment().games(),
                          row_format(scenario.experiment()), "0.1.0-test");
  }

  TemporaryFolder parent_;
  Scenario scenario_ = comparison_with_opponent();
};

TEST_F(ReusedGames, GiveTheSameResultsAsPlayedOnes) {
  play(scenario_, "first");
  scenario_.as<Comparison>()->teams[kNewTeam].robots = 3;
  EXPECT_EQ(play(scenario_, "played").played, 6 * kReusedPairs);
  const ExperimentReport report = play(scenario_, "reused", "first");
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.played, 4 * kReusedPairs);  // all but those of old against zone
  for (const char* name : {kResultsFile, "comparison.csv", "parts.csv", "play.csv", "summary.csv"})
    EXPECT_EQ(file("reused", name), file("played", name)) << name;
}

TEST_F(ReusedGames, AreKeptInTheFolder) {
  play(scenario_, "first");
  EXPECT_EQ(play(scenario_, "second", "first").played, 0);
  fs::remove_all(parent_ / "first");
  EXPECT_EQ(play(scenario_, "second", "first").played, 0);
  EXPECT_EQ(play(scenario_, "third", "second").played, 0);
  EXPECT_EQ(file("third"), file("second"));
}

TEST_F(ReusedGames, AreThoseOfTheSameSeedSettingsAndBuild) {
  play(scenario_, "first");
  Scenario other = scenario_;
  other.as<Comparison>()->seed = 1;
  EXPECT_EQ(play(other, "seed", "first").played, 6 * kReusedPairs);
  other = scenario_;
  other.as<Comparison>()->base.match.half_s = 7;
  EXPECT_EQ(play(other, "setting", "first").played, 6 * kReusedPairs);
  EXPECT_EQ(play(scenario_, "build", "first", "0.2.0-test").played, 6 * kReusedPairs);
}

TEST_F(ReusedGames, AreThoseOfProgramsWithTheSameFiles) {
  auto& old = scenario_.as<Comparison>()->teams[kOldTeam];
  old.program.command = {"old"};
  old.files_hash = "1";
  play(scenario_, "first");
  EXPECT_EQ(reusable(scenario_, "first").rows.size(), 6U * kReusedPairs);
  old.files_hash = "2";
  EXPECT_EQ(reusable(scenario_, "first").rows.size(), 2U * kReusedPairs);  // new against zone
}

TEST_F(ReusedGames, AreNotThoseOfProgramsWithUnknownFiles) {
  scenario_.as<Comparison>()->teams[kOldTeam].program.command = {"old"};
  play(scenario_, "first");
  const ReusableGames games = reusable(scenario_, "first");
  EXPECT_EQ(games.rows.size(), 2U * kReusedPairs);
  EXPECT_TRUE(games.note.starts_with("6 of 18 games are taken over from ")) << games.note;
  EXPECT_TRUE(has(games.note, "; 12 are not, because the files of a program are unknown: "));
}

TEST_F(ReusedGames, AreNeitherVoidNorUnrepeatable) {
  ExperimentOptions options = fake_options(parent_ / "first");
  options.play = [](const game::GameConfiguration& game) {
    game::GameRecord record = fake_game(game);
    if (game.id == "new~zone-p0001-1") record = void_record("team a ended");
    if (game.id == "new~zone-p0001-2") record.is_repeatable = false;
    return record;
  };
  run_experiment(scenario_, options);
  EXPECT_EQ(reusable(scenario_, "first").rows.size(), 6U * kReusedPairs - 2);
}

TEST_F(ReusedGames, MayBeMissing) {
  EXPECT_EQ(play(scenario_, "second", "first").played, 6 * kReusedPairs);
  EXPECT_TRUE(
      reusable(scenario_, "first").note.ends_with("does not exist yet; all games are played"));
  fs::create_directory(parent_ / "empty");
  EXPECT_TRUE(reusable(scenario_, "empty").note.ends_with("holds no games; all games are played"));
}

TEST_F(ReusedGames, OfOtherExperimentsDoNotCount) {
  run_experiment(small_sweep(), fake_options(parent_ / "sweep"));
  const ReusableGames games = reusable(scenario_, "sweep");
  EXPECT_TRUE(games.rows.empty());
  EXPECT_TRUE(games.note.starts_with("no game is taken over: ")) << games.note;
}

TEST_F(ReusedGames, AreInAFolder) {
  write_content(parent_ / "file", "");
  EXPECT_THROW(reusable(scenario_, "file"), std::runtime_error);
}

}  // namespace
}  // namespace autoref::experiments
