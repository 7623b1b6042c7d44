// Every number of a rule book is a setting, below match.rule.
#include <gtest/gtest.h>

#include <string>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::game {
namespace {

GameSettings ruled_game(const std::string& book) {
  GameSettings game;
  set_by_path(game, "match.rules", book);
  return game;
}

TEST(RuleNumbers, AreAllSettings) {
  GameSettings game = ruled_game("2026-b");
  const std::vector<Setting> settings = settings_of(game);
  RuleBook::visit(game.match.rules, [&](const auto& number, const Parameter& about) {
    const Setting* setting = find_setting(settings, path_of_number(about.name));
    ASSERT_NE(setting, nullptr) << about.name;
    EXPECT_EQ(setting->about, about.about);
    using Number = std::remove_cvref_t<decltype(number)>;
    EXPECT_EQ(std::get<Number*>(setting->target), &number) << about.name;
  });
}

TEST(RuleNumbers, ReachTheGameThatIsPlayed) {
  GameSettings game = ruled_game("2026-b");
  set_by_path(game, "match.rule.double_touch_m", "0.15");
  set_by_path(game, "match.rule.clock_stops", "false");
  const GameConfiguration played = resolved(game);
  EXPECT_DOUBLE_EQ(played.match.rules.double_touch_m, 0.15);
  EXPECT_FALSE(played.match.rules.clock_stops);
  EXPECT_DOUBLE_EQ(referee_configuration(played).rules.double_touch_m, 0.15);
  EXPECT_DOUBLE_EQ(obeyed_rules(played, played.a).double_touch_m, 0.15);
}

TEST(RuleNumbers, TakePrecedenceOverTheRuleBookInAnyOrder) {
  GameSettings game;
  set_by_path(game, "match.rule.kick_limit_mps", "7");
  set_by_path(game, "match.rules", "2026-b");
  EXPECT_DOUBLE_EQ(game.match.rules.kick_limit_mps, 7);
  EXPECT_DOUBLE_EQ(game.match.rules.dribbling_m, 1);
}

TEST(RuleNumbers, ChangeTheIdentityOfAGameOnlyIfTheyDiffer) {
  const std::uint64_t official = configuration_hash(ruled_game("2026-b"));
  GameSettings same = ruled_game("2026-b");
  set_by_path(same, "match.rule.double_touch_m", "0.05");
  EXPECT_EQ(configuration_hash(same), official);
  GameSettings other = ruled_game("2026-b");
  set_by_path(other, "match.rule.double_touch_m", "0.0500001");
  EXPECT_NE(configuration_hash(other), official);
}

TEST(RuleNumbers, AreReadBackFromTheEffectiveText) {
  GameSettings game = ruled_game("2026-b");
  set_by_path(game, "match.rule.dribbling_m", "0.7");
  set_by_path(game, "match.rule.fouls_per_card", "5");
  const std::string text = experiments::effective_text({"A game.", game});
  const auto again =
      std::get<GameSettings>(experiments::read_scenario_text(text, "effective.yaml").content);
  EXPECT_EQ(again.match.rules, game.match.rules);
}

TEST(RuleNumbers, ThatContradictEachOtherAreRefusedWithTheirPaths) {
  GameSettings game = ruled_game("2026-b");
  try {
    assign_all(assignments_in({"match.rule.double_touch_m=0.02"}), game);
    FAIL() << "accepted";
  } catch (const io::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(
        message.find("match.rule.in_play_m is 0.05; it must be at most double_touch_m (0.02)"),
        std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace autoref::game
