// Every scenario file can be read, and its games can be played, shortened.
#include <gtest/gtest.h>

#include <algorithm>

#include "runner/experiment.hpp"
#include "runner/judge_games.hpp"
#include "runner/plan.hpp"
#include "runner/scenario.hpp"
#include "tests/runner/temporary_folder.hpp"

namespace autoref::runner {
namespace {

std::vector<std::string> scenario_files() {
  std::vector<std::string> files;
  const std::filesystem::path folder = std::filesystem::path(AUTOREF_SOURCE_DIR) / "scenarios";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

constexpr double kShortHalf_s = 5;

// One pair of short games of each kind.
void shorten(Scenario& experiment) {
  const auto to_a_pair = [](auto& content) {
    content.base.match.half_s = kShortHalf_s;
    content.pairs = 1;
  };
  if (auto* sweep = std::get_if<Sweep>(&experiment.content)) return to_a_pair(*sweep);
  to_a_pair(std::get<RoundRobin>(experiment.content));
}

class EveryScenario : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenario, ReadsBackEqualFromItsEffectiveText) {
  const std::string text = effective_text(read_scenario(GetParam()));
  EXPECT_EQ(effective_text(read_scenario_text(text, "effective.yaml")), text);
}

TEST_P(EveryScenario, CanBePlayedShortened) {
  Scenario scenario = read_scenario(GetParam());
  if (auto* game = std::get_if<GameConfiguration>(&scenario.content)) {
    game->match.half_s = kShortHalf_s;
    EXPECT_EQ(play(*game).status, Status::kOk);
    return;
  }
  if (auto* plan = std::get_if<JudgePlan>(&scenario.content)) {
    plan->base.match.half_s = kShortHalf_s;
    plan->games = 2;
    for (const Judgement& judgement : judge_games(games_of(*plan), 2, nullptr)) {
      EXPECT_EQ(judgement.void_reason, "");
    }
    return;
  }
  shorten(scenario);
  const TemporaryFolder folder;
  ExperimentOptions options;
  options.folder = folder.path();
  options.build = "test";
  options.workers = 2;
  options.play = [](const GameConfiguration& game) { return play(game); };
  const ExperimentReport report = run_experiment(scenario, options);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.void_games, 0);
}

INSTANTIATE_TEST_SUITE_P(Files, EveryScenario, testing::ValuesIn(scenario_files()),
                         [](const auto& test) {
                           std::string name = std::filesystem::path(test.param).stem();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace autoref::runner
