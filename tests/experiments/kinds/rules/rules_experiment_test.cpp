#include "experiments/kinds/rules/rules_experiment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiments/kinds/scenario_reader.hpp"
#include "game/settings/fields.hpp"
#include "soccer/rules/rule_changes.hpp"
#include "tests/experiments/kinds/rules/small_rules.hpp"
#include "tests/experiments/reading/mistake.hpp"

namespace autoref::experiments {
namespace {

RulesExperiment rules_read_from(const std::string& text, const game::Assignments& sets = {}) {
  return *read_scenario_text(text, "x.yaml", sets).as<RulesExperiment>();
}

RulesExperiment with_variants(const std::string& variants) {
  return rules_read_from(kRulesTop + kRulesTeams + "variants:\n" + variants);
}

game::GameSettings settings_in(const RulesExperiment& rules, const std::string& id) {
  for (const ScheduledGame& game : rules.games())
    if (game.id == id) return game.settings.combined();
  ADD_FAILURE() << "no game " << id;
  return {};
}

std::vector<std::string> rule_game_ids(const RulesExperiment& rules) {
  std::vector<std::string> ids;
  for (const ScheduledGame& game : rules.games()) ids.push_back(game.id);
  return ids;
}

TEST(ReadRules, KeepsTheOrderOfTheVariants) {
  const RulesExperiment rules = with_variants(
      "  official: {}\n  long: { match.rule.dribbling_m: 2 }\n  a: { field.width_m: 7 }\n");
  ASSERT_EQ(rules.variants.size(), 3U);
  EXPECT_EQ(rules.variants[0].name, "official");
  EXPECT_TRUE(rules.variants[0].settings.empty());
  EXPECT_EQ(rules.variants[1].name, "long");
  EXPECT_EQ(rules.variants[1].settings.at("match.rule.dribbling_m"), game::SettingValue(2.0));
  EXPECT_EQ(rules.variants[2].name, "a");
  EXPECT_EQ(rules.pairs, 2);
  EXPECT_EQ(rules.seed, 7U);
}

TEST(RulesSchedule, PlaysEveryMatchupUnderEveryVariantBeforeTheNextPair) {
  RulesExperiment rules = with_variants("  official: {}\n  long: { match.rule.dribbling_m: 2 }\n");
  rules.teams["calm"] = {};
  const std::vector<std::string> ids = rule_game_ids(rules);
  ASSERT_EQ(ids.size(), 24U);  // 2 variants x 3 matchups x 2 pairs x 2 legs
  const std::set<std::string> first(ids.begin(), ids.begin() + 12);
  for (const std::string variant : {"official", "long"}) {
    for (const std::string teams : {"bold~calm", "bold~zone", "calm~zone"}) {
      EXPECT_TRUE(first.contains(variant + "+" + teams + "-p0001-1"));
      EXPECT_TRUE(first.contains(variant + "+" + teams + "-p0001-2"));
    }
  }
}

// Common random numbers: the variants differ only in their rules.
TEST(RulesSchedule, GivesAllVariantsTheSameSeedsAndSides) {
  const RulesExperiment rules =
      with_variants("  official: {}\n  long: { match.rule.dribbling_m: 2 }\n");
  const game::GameSettings official = settings_in(rules, "official+bold~zone-p0002-2");
  const game::GameSettings changed = settings_in(rules, "long+bold~zone-p0002-2");
  EXPECT_EQ(official.seed, changed.seed);
  EXPECT_EQ(official.match.a_plays, changed.match.a_plays);
  EXPECT_EQ(official.match.rules.dribbling_m, 1);
  EXPECT_EQ(changed.match.rules.dribbling_m, 2);
  EXPECT_EQ(text_of(rule_changes(official.match.rules, official.field)), "");
  EXPECT_EQ(text_of(rule_changes(changed.match.rules, changed.field)), "dribbling 2 m (1)");
}

TEST(RulesSchedule, KeepsItsGamesWhenVariantsAreAdded) {
  const std::string two = "  official: {}\n  long: { match.rule.dribbling_m: 2 }\n";
  const RulesExperiment few = with_variants(two);
  const RulesExperiment many = with_variants("  wide: { field.width_m: 7 }\n" + two);
  for (const ScheduledGame& game : few.games())
    EXPECT_EQ(game::configuration_hash(game.settings.combined()),
              game::configuration_hash(settings_in(many, game.id)));
}

// zone has 5 robots, which is not the number of 2026-b; bold has 6, which is.
TEST(RulesSchedule, ARuleBookChangesItsFieldAndTheUsualNumberOfRobots) {
  const RulesExperiment rules = with_variants(
      "  official: {}\n  a: { match.rules: 2026-a }\n"
      "  a-8: { match.rules: 2026-a, a.robots: 8, b.robots: 8 }\n");
  const game::GameSettings official = settings_in(rules, "official+bold~zone-p0001-1");
  EXPECT_EQ(official.field.length_m, 9);
  EXPECT_EQ(official.a.robots, 6);
  EXPECT_EQ(official.b.robots, 5);
  const game::GameSettings large = settings_in(rules, "a+bold~zone-p0001-1");
  EXPECT_EQ(large.match.rules.name, "2026-a");
  EXPECT_EQ(large.field.length_m, 12);
  EXPECT_EQ(large.a.robots, 11);
  EXPECT_EQ(large.b.robots, 5);
  const game::GameSettings eight = settings_in(rules, "a-8+bold~zone-p0001-1");
  EXPECT_EQ(eight.field.length_m, 12);
  EXPECT_EQ(eight.a.robots, 8);
  EXPECT_EQ(eight.b.robots, 8);
}

TEST(RulesSchedule, ASettingOfTheBaseTakesPrecedenceOverTheVariantsRuleBook) {
  const RulesExperiment rules = rules_read_from(
      "schema: 1\nkind: rules\npairs: 1\nseed: 7\n"
      "base: { match: { rules: 2026-b, half_s: 100 } }\n" +
      kRulesTeams + "variants: { official: {}, old: { match.rules: 2014 } }\n");
  EXPECT_EQ(settings_in(rules, "old+bold~zone-p0001-1").match.half_s, 100);
  EXPECT_EQ(settings_in(rules, "old+bold~zone-p0001-1").match.rules.name, "2014");
}

class EffectiveRules : public testing::TestWithParam<const char*> {};

TEST_P(EffectiveRules, ReadBackEqual) {
  const RulesExperiment rules = with_variants(GetParam());
  const RulesExperiment back = rules_read_from(effective_text({"", rules}));
  ASSERT_EQ(rule_game_ids(back), rule_game_ids(rules));
  for (const ScheduledGame& game : rules.games())
    EXPECT_EQ(game::configuration_hash(settings_in(back, game.id)),
              game::configuration_hash(game.settings.combined()))
        << game.id;
}

INSTANTIATE_TEST_SUITE_P(
    Variants, EffectiveRules,
    testing::Values(
        "  official: {}\n  long: { match.rule.dribbling_m: 2 }\n",
        "  official: {}\n  old: { match.rules: 2014 }\n",
        "  large: { match.rules: 2026-a }\n  official: {}\n",
        "  official: {}\n  off: { match.switch.offside: true, field.width_m: 7 }\n",
        "  official: {}\n  many: { a.robots: 8, b.robots: 8 }\n",
        "  official: {}\n  short: { match.half_s: 150 }\n  old: { match.rules: 2014 }\n",
        "  wide: { field.width_m: 8 }\n  large: { match.rules: 2026-a }\n",
        "  long: { match.rule.dribbling_m: 2 }\n  old: { match.rules: 2014 }\n",
        "  many: { a.robots: 8, b.robots: 8 }\n  large: { match.rules: 2026-a }\n"));

// A rule book would set the kicker and the dribbler.
TEST(EffectiveRules, KeepThePresetsOfTheBase) {
  const std::string presets =
      "base: { match: { rules: 2026-b }, sim: { dribbler: { preset: perfect }, camera: realistic } "
      "}\n";
  const RulesExperiment rules = rules_read_from(
      "schema: 1\nkind: rules\npairs: 1\nseed: 7\n" + presets + kRulesTeams +
      "variants: { official: {}, old: { match.rules: 2014 }, large: { match.rules: 2026-a } }\n");
  game::GameSettings expected;
  for (const auto& [path, text] : {std::pair{"match.rules", "2026-b"},
                                   {"sim.dribbler.preset", "perfect"},
                                   {"sim.camera", "realistic"}})
    game::set_by_path(expected, path, text);
  const RulesExperiment back = rules_read_from(effective_text({"", rules}));
  for (const ScheduledGame& game : rules.games()) {
    const game::GameSettings settings = game.settings.combined();
    EXPECT_EQ(game::value_at(settings, "sim.dribbler.preset"), "perfect") << game.id;
    EXPECT_EQ(game::value_at(settings, "sim.camera"), game::value_at(expected, "sim.camera"));
    EXPECT_EQ(game::configuration_hash(settings),
              game::configuration_hash(settings_in(back, game.id)))
        << game.id;
  }
}

TEST(ReadRules, RefusesACommandLineSettingThatAVariantChanges) {
  const game::Assignments sets = {
      {"--set match.rule.dribbling_m=3", "match.rule.dribbling_m", "3"}};
  try {
    rules_read_from(effective_text(small_rules()), sets);
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("the file varies this setting"), std::string::npos);
  }
}

TEST(ReadRules, AppliesOtherCommandLineSettingsToAllGames) {
  const game::Assignments sets = {{"--set match.half_s=50", "match.half_s", "50"}};
  const RulesExperiment rules = rules_read_from(effective_text(small_rules()), sets);
  EXPECT_EQ(settings_in(rules, "official+bold~zone-p0001-1").match.half_s, 50);
  EXPECT_EQ(settings_in(rules, "long+bold~zone-p0001-1").match.half_s, 50);
}

class WrongRules : public testing::TestWithParam<Mistake> {};

TEST_P(WrongRules, AreRefusedWithTheirLocationAndARemedy) { expect_refused(GetParam()); }

const std::string kBefore = kRulesTop + kRulesTeams;

INSTANTIATE_TEST_SUITE_P(
    Files, WrongRules,
    testing::Values(
        Mistake{"NoVariants", kBefore, "x.yaml:1:1: ", {"'variants' is missing"}},
        Mistake{"OneVariant",
                kBefore + "variants: { official: {} }\n",
                "x.yaml:7:1: variants: ",
                {"at least two variants"}},
        Mistake{"NameWithASpace",
                kBefore + "variants: { official: {}, \"2 m\": {} }\n",
                "x.yaml:7:27: variants: ",
                {"a variant's name", "'2 m'"}},
        Mistake{"VariantTwice",
                kBefore + "variants: { official: {}, official: {} }\n",
                "x.yaml:7:27: ",
                {"'official' is given twice"}},
        Mistake{"UnknownNumber",
                kBefore + "variants: { official: {}, x: { match.rule.dribling_m: 2 } }\n",
                "x.yaml:7:55: ",
                {"'match.rule.dribbling_m'"}},
        Mistake{"OutOfRange",
                kBefore + "variants: { official: {}, x: { match.rule.dribbling_m: -1 } }\n",
                "x.yaml:7:56: ",
                {"found '-1'"}},
        Mistake{"NotARule",
                kBefore + "variants: { official: {}, x: { sim.robot.speed_mps: 2 } }\n",
                "x.yaml:7:32: sim.robot.speed_mps: ",
                {"match, field, a.robots and b.robots", "base or teams"}},
        Mistake{"OtherTeam",
                kBefore + "variants: { official: {}, x: { a.strategy: zone } }\n",
                "x.yaml:7:32: a.strategy: ",
                {"match, field, a.robots and b.robots"}},
        Mistake{"SetByTheSchedule",
                kBefore + "variants: { official: {}, x: { match.a_plays: east } }\n",
                "x.yaml:7:32: ",
                {"set automatically"}},
        Mistake{"SameSettingTwice",
                kBefore + "variants: { official: {}, x: { a.robots: 5, teams.a.robots: 6 } }\n",
                "x.yaml:7:45: teams.a.robots: ",
                {"given twice"}},
        Mistake{"List",
                kBefore + "variants: { official: {}, x: { match.rule.dribbling_m: [1, 2] } }\n",
                "x.yaml:7:56: ",
                {"a plain value"}},
        Mistake{"Contradiction",
                kBefore + "variants: { official: {}, x: { match.rule.double_touch_m: 0.01 } }\n",
                "x.yaml:7:27: ",
                {"variants.x.match.rule.in_play_m is 0.05", "double_touch_m (0.01)"}},
        Mistake{"TooLargeForTheField",
                kBefore + "variants: { official: {}, x: { field.defence_area.depth_m: 4.6 } }\n",
                "x.yaml:7:32: ",
                {"variants.x.field.defence_area.depth_m is 4.6"}},
        Mistake{"EqualVariants",
                kBefore + "variants: { x: { field.width_m: 7 }, y: { field.width_m: 7.0 } }\n",
                "x.yaml:7:38: variants.y: ",
                {"the same settings as 'x'"}},
        Mistake{"GameController",
                kBefore + "variants: { official: {}, x: { match.control: game-controller } }\n",
                "x.yaml:7:32: variants.x.match.control",
                {"autoref play"}},
        Mistake{
            "OneTeam",
            kRulesTop + "teams: { bold: {} }\nvariants: { official: {}, x: { match.half_s: 9 } }\n",
            "x.yaml:6:1: teams: ",
            {"at least 2 teams"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::experiments
