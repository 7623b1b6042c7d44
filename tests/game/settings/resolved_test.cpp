#include "game/settings/game_settings.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "game/settings/fields.hpp"
#include "game/settings/setting_value.hpp"

namespace autoref::game {
namespace {

TEST(ResolvedGame, OfDefaultSettingsIsTheDefaultGame) {
  const GameConfiguration game = resolved(GameSettings{});
  EXPECT_EQ(game.match.rules, GameConfiguration{}.match.rules);
  EXPECT_EQ(game.a.robots.size(), GameConfiguration{}.a.robots.size());
  EXPECT_EQ(game.match.half_s, GameConfiguration{}.match.half_s);
  EXPECT_EQ(game.seed, GameConfiguration{}.seed);
}

TEST(ResolvedGame, HasTheRuleBookWithItsRulesSwitchedAsSet) {
  GameSettings settings;
  set_by_path(settings, "match.rules", "2026-b");
  set_by_path(settings, "match.switch.no_progress_in_game", "false");
  set_by_path(settings, "match.extra_half_s", "120");
  const RuleBook rules = resolved(settings).match.rules;
  RuleBook expected = *find_rule_book("2026-b");
  expected.in_force[RuleId::kNoProgressInGame] = false;
  expected.extra_half_s = 120;
  EXPECT_EQ(rules, expected);
}

TEST(ResolvedGame, HasRealRobotsUnderTheLawsAndThePapersUnderItsRules) {
  GameSettings settings;
  set_by_path(settings, "match.rules", "2014");
  const GameConfiguration laws = resolved(settings);
  EXPECT_EQ(laws.a.robots[0].kicker.direction_noise_deg, 2.9);
  EXPECT_EQ(laws.b.robots[5].dribbler.force_n, 0.225);
  EXPECT_EQ(laws.sim.latency_error_s, 0.01);
  set_by_path(settings, "match.rules", "paper");
  const GameConfiguration paper = resolved(settings);
  EXPECT_EQ(paper.a.robots[0].kicker, sim::KickerParameters{});
  EXPECT_EQ(paper.a.robots[0].dribbler, sim::DribblerParameters{});
  EXPECT_EQ(paper.sim.latency_error_s, 0);
}

TEST(ResolvedGame, HasTeamsThatKnowTheLawsOf2014) {
  const GameConfiguration game = resolved(GameSettings{});
  EXPECT_EQ(game.a.laws, find_rule_book("2014"));
  EXPECT_EQ(game.b.laws, find_rule_book("2014"));
}

TEST(ResolvedGame, HasTheLawsThatEachTeamIsSetToKnow) {
  GameSettings settings;
  set_by_path(settings, "a.laws", "2026-b");
  set_by_path(settings, "b.laws", "enforced");
  const GameConfiguration game = resolved(settings);
  EXPECT_EQ(game.a.laws, find_rule_book("2026-b"));
  EXPECT_EQ(game.b.laws, std::nullopt);
}

TEST(ResolvedGame, RefusesTheNameOfThePapersBookAsLaws) {
  GameSettings settings;
  EXPECT_THROW(set_by_path(settings, "a.laws", "paper"), std::invalid_argument);
}

TEST(ResolvedGame, ChangesEndsByTheRuleBookUnlessItIsSet) {
  GameSettings settings;
  set_by_path(settings, "match.rules", "2014");
  EXPECT_TRUE(resolved(settings).match.rules.change_ends);
  set_by_path(settings, "match.change_ends", "false");
  EXPECT_FALSE(resolved(settings).match.rules.change_ends);
}

TEST(ResolvedGame, AppliesTheOverridesOfTeamAndNumberToEachRobot) {
  GameSettings settings;
  set_by_path(settings, "b.robots", "5");
  set_by_path(settings, "b.robot.speed_mps", "1.5");
  set_by_path(settings, "b.players.3.speed_factor", "0.5");
  const GameConfiguration game = resolved(settings);
  ASSERT_EQ(game.b.robots.size(), 5U);
  EXPECT_EQ(game.b.robots[0].body.speed_mps, 1.5);
  EXPECT_EQ(game.b.robots[3].speed_factor, 0.5);
  EXPECT_EQ(game.a.robots.size(), 6U);
}

TEST(ChosenRules, MustBeAKnownRuleBook) {
  GameSettings settings;
  EXPECT_THROW(choose_rules("none", settings), std::invalid_argument);
}

TEST(ResolvedGame, RefusesAPlayerThatTheTeamDoesNotHave) {
  GameSettings settings;
  settings.a.players[6] = {};
  try {
    resolved(settings);
    FAIL() << "accepted";
  } catch (const SettingError& error) {
    EXPECT_EQ(error.path(), "teams.a.players.6");
  }
}

TEST(SpeltValue, IsTheSameForEqualValues) {
  EXPECT_EQ(spelt(SettingValue(1.0)), "1.0");
  EXPECT_EQ(spelt(SettingValue(0.80)), "0.8");
  EXPECT_EQ(spelt(SettingValue(1)), "1");
  EXPECT_EQ(spelt(SettingValue(std::uint64_t{18446744073709551615U})), "18446744073709551615");
  EXPECT_EQ(spelt(SettingValue(std::string("basic"))), "basic");
}

}  // namespace
}  // namespace autoref::game
