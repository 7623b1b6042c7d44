// Scenes are played, stored and summarised like games.
#include <gtest/gtest.h>

#include "experiments/kinds/situations/situations.hpp"
#include "experiments/results/shard.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/run/run_experiment.hpp"
#include "experiments/run/verification.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

ExperimentOptions real_options(const std::filesystem::path& folder, int workers) {
  ExperimentOptions options = fake_options(folder);
  options.workers = workers;
  options.play = [](const game::GameConfiguration& game) { return game::play(game); };
  return options;
}

TEST(SituationsRun, GivesTheSameRowsForOneAndTwoWorkers) {
  const TemporaryFolder one;
  const TemporaryFolder two;
  ASSERT_TRUE(run_experiment(small_situations(), real_options(one.path(), 1)).is_complete);
  ASSERT_TRUE(run_experiment(small_situations(), real_options(two.path(), 2)).is_complete);
  for (const char* file : {"results.csv", "summary.csv", "differences.csv", "effective.yaml"})
    EXPECT_EQ(content_of(one / file), content_of(two / file)) << file;
}

TEST(SituationsRun, ScoresTheBallThatRollsIntoTheGoalAndNotTheOneAtRest) {
  const TemporaryFolder folder;
  run_experiment(small_situations(), real_options(folder.path(), 1));
  const ResultFolder results = open_results(folder.path());
  ASSERT_EQ(results.completed_games.done.size(), 16U);
  for (const auto& [id, row] : results.completed_games.done) {
    ASSERT_TRUE(row.record.scene) << id;
    const bool is_goal = row.values.front() == "goal";
    EXPECT_EQ(row.record.scene->score, is_goal ? 1 : 0) << id;
    EXPECT_EQ(row.record.scene->ended_by, is_goal ? game::SceneEnd::kGoal : game::SceneEnd::kTime)
        << id;
    EXPECT_EQ(row.record.scene->gained_m > 0.5, is_goal) << id;
  }
  const std::string summary = content_of(folder / "summary.csv");
  EXPECT_NE(summary.find("\ngoal,one,still,4,0,4,1.0000,"), std::string::npos) << summary;
  EXPECT_NE(summary.find("\nrest,two,still,4,0,0,0.0000,"), std::string::npos) << summary;
}

TEST(SituationsRun, ContinuesAndIsVerified) {
  const TemporaryFolder folder;
  Scenario scenario = small_situations();
  run_experiment(scenario, real_options(folder.path(), 1));
  scenario.as<Situations>()->pairs = 3;
  const ExperimentReport report = run_experiment(scenario, real_options(folder.path(), 1));
  EXPECT_EQ(report.played, 8);
  EXPECT_EQ(report.done, 24);
  const auto again = [](const game::GameConfiguration& game, GameRow& row) {
    row.record = game::play(game);
  };
  const Verification verification = verify(open_results(folder.path()), 6, 1, again, nullptr);
  EXPECT_EQ(verification.played, 6);
  EXPECT_TRUE(verification.differences.empty());
}

TEST(SituationsRun, RefusesToContinueWithOtherPositions) {
  const TemporaryFolder folder;
  Scenario scenario = small_situations();
  run_experiment(scenario, real_options(folder.path(), 1));
  scenario.as<Situations>()->situations.at("rest").ball.x_m = 0.5;
  try {
    run_experiment(scenario, real_options(folder.path(), 1));
    FAIL() << "continued";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("situations.rest.ball.x_m is 0.5 here and 0.0 there"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace autoref::experiments
