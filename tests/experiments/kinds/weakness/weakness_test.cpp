// `kind: weakness`: the search, its tests, the reduction and the files, with fake games.
#include "experiments/kinds/weakness/weakness.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "experiments/kinds/weakness/weakness_report.hpp"
#include "experiments/kinds/weakness/weakness_state.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/statistics/sample.hpp"
#include "soccer/random.hpp"
#include "tests/experiments/kinds/weakness/small_weakness.hpp"
#include "tests/experiments/reading/mistake.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

Scenario weakness_scenario() { return read_scenario_text(weakness_text(), "x.yaml"); }

game::GameRecord scene_in_which(bool has_scored, const game::GameConfiguration& game) {
  game::GameRecord record;
  record.goals_a = has_scored ? 1 : 0;
  record.scene = game::SceneRecord{.score = has_scored ? 1.0 : 0.0};
  record.frames = 600;
  record.sim_s = 6;
  record.state_hash = game.seed;
  return record;
}

// The start as seen by the attackers, who are team a.
game::StartState start_for_attackers(const game::GameConfiguration& game) {
  const bool is_in_west = &team_on(game, Side::kWest) == &game.a;
  return is_in_west ? *game.start : game::mirrored(*game.start);
}

bool has_robot(const sim::RobotStates& robots, int number) {
  return std::any_of(robots.begin(), robots.end(),
                     [number](const sim::RobotState& robot) { return robot.number == number; });
}

// Attacker 2 scores past defender 3 if the ball is near the line y = 1, and otherwise seldom.
game::GameRecord planted_weakness(const game::GameConfiguration& game) {
  const game::StartState start = start_for_attackers(game);
  const double distance_m = std::abs(start.ball.position_m.y() - 1);
  const bool is_planted =
      has_robot(start.robots[Side::kWest], 2) && has_robot(start.robots[Side::kEast], 3);
  RandomStream random(game.seed);
  const double chance = is_planted ? 0.9 * std::max(0.0, 1 - distance_m / 1.5) : 0.05;
  return scene_in_which(random.uniform() < chance, game);
}

// A goal in one scene of five, whatever the situation.
game::GameRecord without_weakness(const game::GameConfiguration& game) {
  RandomStream random(game.seed);
  return scene_in_which(random.uniform() < 0.2, game);
}

ExperimentOptions weakness_options(const TemporaryFolder& folder, PlayGame play) {
  ExperimentOptions options = fake_options(folder.path());
  options.play = std::move(play);
  return options;
}

WeaknessState state_in(const TemporaryFolder& folder, const Scenario& scenario) {
  return state_of(scenario.get<Weakness>(), open_results(folder.path()).completed_games.done);
}

TEST(Weakness, FindsAPlantedWeaknessAndTheRobotsThatShowIt) {
  const TemporaryFolder folder;
  const Scenario scenario = weakness_scenario();
  const ExperimentReport report =
      run_experiment(scenario, weakness_options(folder, planted_weakness));
  EXPECT_TRUE(report.is_complete);
  const WeaknessState state = state_in(folder, scenario);
  ASSERT_EQ(state.finds.size(), 2U);
  for (const Find& find : state.finds) {
    EXPECT_TRUE(find.is_confirmed);
    const Distribution& y_m = find.test->trial.situation.ball.y_m;
    EXPECT_LT(y_m.first, 1.3);
    EXPECT_GT(y_m.second, 0.7);
    EXPECT_GT(*find.test->excess.mean, 0.3);
    ASSERT_TRUE(find.reduced);
    EXPECT_EQ(robots_of(find.reduced->trial.situation),
              (std::vector<RobotOfSituation>{{true, 2}, {false, 3}}));
    EXPECT_GT(*find.reduced->excess.mean, 0.3);
  }
}

TEST(Weakness, ConfirmsNothingIfNoSituationIsWorse) {
  const TemporaryFolder folder;
  const Scenario scenario = weakness_scenario();
  run_experiment(scenario, weakness_options(folder, without_weakness));
  const WeaknessState state = state_in(folder, scenario);
  EXPECT_TRUE(state.is_complete);
  for (const Find& find : state.finds) EXPECT_FALSE(find.is_confirmed);
  EXPECT_EQ(content_of(folder / kWeaknessesFile), "# No weakness was confirmed.\n");
}

// Seven times with other seeds: at most one of them may confirm something by chance, since the
// corrected p value is at most 0.05. More than one has a probability of 4 %.
TEST(Weakness, TestsOnScenesThatTheSearchHasNotSeen) {
  int confirmed = 0;
  double searched = 0, tested = 0;
  for (std::uint64_t seed = 1; seed <= 7; ++seed) {
    const TemporaryFolder folder;
    Scenario scenario = weakness_scenario();
    set_master_seed(scenario.experiment(), seed);
    run_experiment(scenario, weakness_options(folder, without_weakness));
    const WeaknessState state = state_in(folder, scenario);
    for (const Find& find : state.finds) {
      confirmed += find.is_confirmed ? 1 : 0;
      tested += mean(find.test->scenes.scores) / 14;
    }
    double best = 0;
    for (const SearchStep& step : state.steps) best = std::max(best, *step.best_score);
    searched += best / 7;
  }
  EXPECT_LE(confirmed, 1);
  EXPECT_NEAR(tested, 0.2, 0.04);  // although the best candidates scored
  EXPECT_GT(searched, 0.4);        // far more by chance
}

TEST(Weakness, ContinuesAfterAnInterruption) {
  const TemporaryFolder whole, parts;
  const Scenario scenario = weakness_scenario();
  run_experiment(scenario, weakness_options(whole, planted_weakness));
  for (int i = 0; i < 3; ++i)
    run_experiment(scenario, weakness_options(parts, interrupting(planted_weakness)));
  ExperimentOptions options = weakness_options(parts, planted_weakness);
  options.workers = 3;
  EXPECT_TRUE(run_experiment(scenario, options).is_complete);
  for (const char* file : {"results.csv", "weaknesses.csv", "search.csv", kWeaknessesFile})
    EXPECT_EQ(content_of(parts / file), content_of(whole / file)) << file;
}

TEST(Weakness, WritesAScenarioOfItsFinds) {
  const TemporaryFolder folder;
  const Scenario scenario = weakness_scenario();
  run_experiment(scenario, weakness_options(folder, planted_weakness));
  const WeaknessState state = state_in(folder, scenario);
  const Scenario found = read_scenario(folder / kWeaknessesFile);
  const auto& situations = found.get<Situations>().situations;
  ASSERT_EQ(situations.size(), 4U);
  const SituationSetup& first = situations.at("field-1");
  EXPECT_EQ(first.ball, state.finds[0].test->trial.situation.ball);
  EXPECT_EQ(first.attackers, state.finds[0].test->trial.situation.attackers);
  EXPECT_EQ(situations.at("field-1-reduced").attackers.size(), 1U);
  EXPECT_TRUE(content_of(folder / "field-1.svg").starts_with("<svg"));
}

TEST(Weakness, PlaysAtLeastAsManyScenesAsAnnounced) {
  const Scenario scenario = weakness_scenario();
  const TemporaryFolder folder;
  const ExperimentReport report =
      run_experiment(scenario, weakness_options(folder, without_weakness));
  EXPECT_EQ(report.games, static_cast<int>(scenario.experiment().games().size()));
  // 2 searches of 12 iterations with 7 candidates of 4 pairs, 2 tests and the usual scenes.
  EXPECT_EQ(report.games, 2 * (2 * 12 * 7 * 4 + 3 * 40));
}

// A run with a killed game, or another shard, must not take such a state for the end.
TEST(Weakness, IsIncompleteWithoutOneSceneOfATest) {
  const TemporaryFolder folder;
  const Scenario scenario = weakness_scenario();
  run_experiment(scenario, weakness_options(folder, planted_weakness));
  const RowsById rows = open_results(folder.path()).completed_games.done;
  for (const char* id : {"test-field.1-p0003-1", "usual-field-p0001-2", "final-field.2-p0040-1",
                         "k0004-field.1-x02-p0001-1"}) {
    RowsById others = rows;
    ASSERT_EQ(others.erase(id), 1U) << id;
    const Schedule schedule = scenario.experiment().schedule(others);
    EXPECT_GT(schedule.needed, schedule.games.size()) << id;
  }
  const Schedule whole = scenario.experiment().schedule(rows);
  EXPECT_EQ(whole.needed, whole.games.size());
}

TEST(Weakness, ReadsBackEqualFromTheEffectiveFile) {
  const std::string text = effective_text(weakness_scenario());
  EXPECT_EQ(effective_text(read_scenario_text(text, "effective.yaml")), text);
}

TEST(WeaknessSearch, StaysWithinTheRanges) {
  const Weakness weakness = weakness_scenario().get<Weakness>();
  const SituationSetup& family = weakness.situations.at("field");
  EXPECT_EQ(searched_paths(family, weakness.base.field),
            (std::vector<std::string>{"ball.y_m", "attackers.1.x_m", "attackers.2.x_m"}));
  const auto at = [&](double share, double spread) {
    return situation_at(family, weakness.base.field, Point::Constant(3, 4 * share), spread);
  };
  EXPECT_EQ(at(0.5, 0.1).ball.y_m, Distribution::uniform(-0.2, 0.2));
  EXPECT_EQ(at(1, 0.1).ball.y_m, Distribution::uniform(1.8, 2));
  EXPECT_EQ(at(0.25, 0).attackers[0].x_m, Distribution(-1.75));
  EXPECT_EQ(at(0.5, 1).ball, family.ball);
  EXPECT_EQ(at(0.5, 1).attackers, family.attackers);
}

TEST(WeaknessSearch, GivesCandidatesWithOverlappingRobotsNoScore) {
  Weakness weakness = weakness_scenario().get<Weakness>();
  weakness.spread = 0;
  weakness.situations.at("field").attackers[1].y_m = -1;  // both attackers on the same line
  const WeaknessState state = state_without_finds(weakness);
  std::size_t candidates = 0;
  for (const SceneTrial& trial : state.trials) candidates += trial.name.starts_with("k") ? 1 : 0;
  EXPECT_LT(candidates, 2U * 12 * 7);
  EXPECT_GT(candidates, 12U * 7);
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part))
    text.replace(at, part.size(), by);
  return text;
}

TEST(WeaknessKeys, AreRefusedWithARemedy) {
  const std::string team = "{ one: { strategy: dummy } }";
  for (const Mistake& mistake : std::vector<Mistake>{
           {"no range",
            replaced(replaced(weakness_text(), "[-2, 2]", "0"), "[-2, -1]", "-1.5"),
            "x.yaml:6:3: situations.field",
            {"give at least one value as a range"}},
           {"two teams",
            replaced(weakness_text(), team, "{ one: {}, two: {} }"),
            "x.yaml:3",
            {"attackers", "one team"}},
           {"too many games",
            weakness_text("searches: 99\niterations: 999\n"),
            "x.yaml",
            {"iterations", "games"}},
           {"share above 1", weakness_text("spread: 2\n"), "x.yaml:10:9: spread", {"0 to 1"}}})
    expect_refused(mistake);
}

}  // namespace
}  // namespace autoref::experiments
