#include "experiments/kinds/scenario.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

const std::string kGame = "schema: 1\nkind: game\n";
const std::string kSweep = "schema: 1\nkind: sweep\npairs: 2\nseed: 1\n";

game::GameSettings game_of(const std::string& text) {
  return std::get<game::GameSettings>(read_scenario_text(text, "x.yaml").content);
}

Sweep sweep_of(const std::string& text) { return *read_scenario_text(text, "x.yaml").as<Sweep>(); }

TEST(ReadScenario, KeepsDefaultsForMissingKeys) {
  const game::GameSettings game = game_of(kGame);
  EXPECT_EQ(game.a.robots, 6);
  EXPECT_EQ(game.match.rules.name, "paper");
  EXPECT_EQ(game.match.half_s, 600);  // the paper's ten minutes
}

TEST(ReadScenario, LetsSingleNumbersOverrideAPresetInAnyOrder) {
  const game::GameSettings game =
      game_of(kGame + "sim: { ball: { roll_mps2: 0.5, preset: erforce } }\n");
  EXPECT_EQ(game.sim.ball.slide_mps2, 3.92);
  EXPECT_EQ(game.sim.ball.roll_mps2, 0.5);
}

TEST(ReadScenario, WritesTheNumbersOfAPresetIntoTheEffectiveText) {
  const Scenario scenario =
      read_scenario_text(kGame + "sim: { ball: { preset: tigers } }\n", "x.yaml");
  const std::string text = effective_text(scenario);
  EXPECT_NE(text.find("switch_ratio: 0.667"), std::string::npos);
  EXPECT_EQ(text.find("preset"), std::string::npos);
}

TEST(ReadScenario, ReadsAGame) {
  const game::GameSettings game =
      game_of(kGame +
              "teams: { a: { strategy: dummy, robots: 3 }, b: { handicap: 0.8, params: { shot_mps: "
              "5 } } }\n"
              "match: { half_s: 60, a_plays: east }\nsim: { substeps: 2 }\nseed: 7\n");
  EXPECT_EQ(game.a.strategy, "dummy");
  EXPECT_EQ(game.a.robots, 3);
  EXPECT_EQ(game.b.acceleration_factor, 0.8);
  EXPECT_EQ(game.b.params.at("shot_mps"), 5);
  EXPECT_EQ(game.match.a_plays, Side::kEast);
  EXPECT_EQ(game.sim.substeps, 2);
  EXPECT_EQ(game.seed, 7U);
}

// How long a half is if a game's `match` is changed by --set.
double half_s_with(const std::string& match, const std::vector<std::string>& sets) {
  const std::string text = kGame + "match: { " + match + " }\n";
  const Scenario scenario = read_scenario_text(text, "x.yaml", game::assignments_in(sets));
  return std::get<game::GameSettings>(scenario.content).match.half_s;
}

TEST(ReadScenario, LetsAnotherRuleBookBringItsHalvesUnlessTheFileChoseThem) {
  EXPECT_EQ(half_s_with("rules: paper, half_s: 600", {"match.rules=2026-b"}), 300);
  EXPECT_EQ(half_s_with("half_s: 600", {"match.rules=2026-b"}), 300);
  EXPECT_EQ(half_s_with("rules: 2026-b, half_s: 300", {"match.rules=2014"}), 600);
  EXPECT_EQ(half_s_with("rules: paper, half_s: 60", {"match.rules=2026-b"}), 60);
  EXPECT_EQ(half_s_with("rules: 2026-b, half_s: 600", {"match.rules=2026-a"}), 600);
  EXPECT_EQ(half_s_with("rules: 2026-b, half_s: 600", {}), 600);
  EXPECT_EQ(half_s_with("rules: paper", {"match.half_s=600", "match.rules=2026-b"}), 600);
}

TEST(ReadScenario, TreatsHalvesOfExtraTimeLikewise) {
  const auto extra_half_s = [](const std::string& seconds) {
    const std::string text = kGame + "match: { rules: 2014, extra_half_s: " + seconds + " }\n";
    const Scenario scenario =
        read_scenario_text(text, "x.yaml", game::assignments_in({"match.rules=2026-b"}));
    return std::get<game::GameSettings>(scenario.content).match.rules.extra_half_s;
  };
  EXPECT_EQ(extra_half_s("300"), 150);
  EXPECT_EQ(extra_half_s("100"), 100);
}

TEST(ReadScenario, KeepsTheHalvesOfAnExperimentsBaseUnderAllItsRuleBooks) {
  const Sweep sweep = sweep_of(kSweep +
                               "base: { match: { rules: paper, half_s: 600 } }\n"
                               "factors: { match.rules: [paper, 2026-b] }\n");
  for (const ScheduledGame& game : sweep.games()) EXPECT_EQ(resolved(game).match.half_s, 600);
}

TEST(ReadScenario, ReadsASweep) {
  const Sweep sweep = sweep_of(kSweep +
                               "base: { match: { half_s: 60 } }\n"
                               "factors: { b.handicap: [1, 0.50], teams.b.robots: [6, 5] }\n");
  EXPECT_EQ(sweep.base.match.half_s, 60);
  EXPECT_EQ(sweep.pairs, 2);
  const std::vector<Factor> expected = {{"b.handicap", {1.0, 0.5}}, {"b.robots", {6, 5}}};
  EXPECT_EQ(sweep.factors, expected);
}

TEST(ReadScenario, AcceptsNegativeParametersIfTheirRangeIncludesThem) {
  const game::GameSettings game =
      game_of(kGame + "teams: { a: { strategy: rowdy, params: { otherwise: -1 } } }\n");
  EXPECT_EQ(game.a.params.at("otherwise"), -1);
}

TEST(ReadScenario, AcceptsFactorsThatAreValidOnlyInCombination) {
  const Sweep sweep =
      sweep_of(kSweep + "factors: { field.goal_width_m: [3.8], field.width_m: [9] }\n");
  EXPECT_EQ(sweep.factors.size(), 2U);
}

TEST(EffectiveConfiguration, OfAGameReadsBackEqual) {
  game::GameSettings game;
  game.a.robots = 3;
  game.b.speed_factor = 1.0 / 3.0;
  game.a.params["shot_mps"] = 0.1;
  game.match.a_plays = Side::kEast;
  game.field.defence_area.shape = DefenceArea::Shape::kBox;
  game.seed = 18446744073709551615ULL;
  const Scenario scenario{"A \"quoted\"\nsentence: #1", game};
  const Scenario back = read_scenario_text(effective_text(scenario), "effective.yaml");
  EXPECT_EQ(back.about, scenario.about);
  EXPECT_EQ(game::configuration_hash(std::get<game::GameSettings>(back.content)),
            game::configuration_hash(game));
}

TEST(EffectiveConfiguration, OfASweepReadsBackEqual) {
  Sweep sweep;
  sweep.base.match.half_s = 60;
  sweep.factors = {{"b.handicap", {1.0, 0.5}}, {"a.strategy", {"basic", "dummy"}}};
  sweep.pairs = 30;
  sweep.seed = 7;
  const Sweep back = sweep_of(effective_text({"", sweep}));
  EXPECT_EQ(game::configuration_hash(back.base), game::configuration_hash(sweep.base));
  EXPECT_EQ(back.factors, sweep.factors);
  EXPECT_EQ(back.pairs, 30);
  EXPECT_EQ(back.seed, 7U);
}

// The rule books also set the dribbler.
TEST(EffectiveConfiguration, OfASweepOverRuleBooksWithAPresetReadsBackEqual) {
  const Sweep sweep = sweep_of(
      "schema: 1\nkind: sweep\npairs: 1\nseed: 7\n"
      "base: { match: { rules: 2026-b }, sim: { dribbler: { preset: perfect } } }\n"
      "factors: { match.rules: [2026-b, \"2014\"] }\n");
  const std::vector<ScheduledGame> back = sweep_of(effective_text({"", sweep})).games();
  const std::vector<ScheduledGame> games = sweep.games();
  ASSERT_EQ(back.size(), games.size());
  for (std::size_t i = 0; i < games.size(); ++i) {
    EXPECT_EQ(game::configuration_hash(games[i].settings.combined()),
              game::configuration_hash(back[i].settings.combined()));
  }
}

}  // namespace
}  // namespace autoref::experiments
