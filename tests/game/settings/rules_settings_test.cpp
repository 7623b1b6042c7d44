// match.rules applies a rule book; anything else in the file overrides it.
#include <gtest/gtest.h>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "game/settings/fields.hpp"

namespace autoref::game {
namespace {

GameSettings game_in(const std::string& lines) {
  const std::string text = "schema: 1\nkind: game\nabout: A game.\n" + lines;
  return std::get<GameSettings>(experiments::read_scenario_text(text, "game.yaml").content);
}

TEST(MatchRules, SetTheBooksFieldRobotsAndLength) {
  const GameSettings game = game_in("match: { rules: 2026-a }\n");
  EXPECT_DOUBLE_EQ(game.field.length_m, 12);
  EXPECT_EQ(game.a.robots, 11);
  EXPECT_EQ(game.b.robots, 11);
  EXPECT_DOUBLE_EQ(game.match.half_s, 300);
}

TEST(MatchRules, AreReadFirstWhateverTheirPosition) {
  const GameSettings game = game_in(
      "teams: { a: { robots: 4 } }\nfield: { length_m: 10 }\nmatch: { half_s: 60, rules: 2026-b "
      "}\n");
  EXPECT_EQ(game.a.robots, 4);
  EXPECT_EQ(game.b.robots, 6);
  EXPECT_DOUBLE_EQ(game.field.length_m, 10);
  EXPECT_DOUBLE_EQ(game.field.width_m, 6);
  EXPECT_DOUBLE_EQ(game.match.half_s, 60);
}

TEST(MatchRules, LetAFileSwitchSingleRules) {
  const GameSettings game =
      game_in("match: { switch: { offside: true, bot_crash_unique: false }, rules: 2014 }\n");
  EXPECT_TRUE(game.match.rules.in_force.has(RuleId::kOffside));
  EXPECT_FALSE(game.match.rules.in_force.has(RuleId::kBotCrashUnique));
  EXPECT_TRUE(game.match.rules.in_force.has(RuleId::kBotKickedBallTooFast));
}

TEST(MatchRules, AreReproducedFromTheEffectiveText) {
  const GameSettings game = game_in(
      "match: { rules: 2014-double, switch: { bot_pushed_bot: false } }\nteams: { b: { robots: 3 } "
      "}\n");
  const std::string text = experiments::effective_text({"A game.", game});
  const auto again =
      std::get<GameSettings>(experiments::read_scenario_text(text, "effective.yaml").content);
  EXPECT_EQ(configuration_hash(again), configuration_hash(game));
  EXPECT_DOUBLE_EQ(again.field.length_m, 8.09);
  EXPECT_EQ(again.b.robots, 3);
  EXPECT_FALSE(again.match.rules.in_force.has(RuleId::kBotPushedBot));
}

TEST(MatchRules, DistinguishConfigurations) {
  const GameSettings game = game_in("match: { rules: 2014 }\n");
  GameSettings other = game;
  other.match.rules.in_force[RuleId::kOffside] = true;
  EXPECT_NE(configuration_hash(game), configuration_hash(other));
}

TEST(MatchRules, RefuseAnUnknownSwitchByItsName) {
  try {
    game_in("match: { switch: { ofside: true } }\n");
    FAIL() << "accepted";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'offside'"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace autoref::game
