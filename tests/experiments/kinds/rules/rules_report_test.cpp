#include "experiments/kinds/rules/rules_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/experiments/kinds/rules/small_rules.hpp"

namespace autoref::experiments {
namespace {

struct PlayedUnder {
  std::string variant;
  int pair = 1;
  int goals_bold = 0;
  int goals_zone = 0;
  int double_touches = 0;
  int stops = 0;
};

// Both legs, which last 100 s each; the ball is in play for 60 s in each of them.
void add_legs(const PlayedUnder& played, RowsById& rows) {
  for (const int leg : {1, 2}) {
    GameRow row;
    row.game_id = game_id(played.variant + "+bold~zone", played.pair, leg);
    row.values = {played.variant};
    row.pair = played.pair;
    row.leg = leg;
    row.team_a = "bold";
    row.team_b = "zone";
    row.record.goals_a = played.goals_bold;
    row.record.goals_b = played.goals_zone;
    row.record.events[static_cast<std::size_t>(referee::Event::kGoal)] =
        played.goals_bold + played.goals_zone;
    row.record.events[static_cast<std::size_t>(referee::Event::kAttackerDoubleTouchedBall)] =
        played.double_touches;
    row.record.counts[0].shots = 2;
    row.record.counts[1].shots = 1;
    row.record.stops = played.stops;
    row.record.doubtful_calls = 1;
    row.record.ball_in_play_s = 60;
    row.record.sim_s = 100;
    rows[row.game_id] = row;
  }
}

RowsById rows_with(const std::vector<PlayedUnder>& all) {
  RowsById rows;
  for (const PlayedUnder& played : all) add_legs(played, rows);
  return rows;
}

// zone is the stronger team: it has 9 goals in these pairs, bold has 4.
RowsById three_pairs() {
  return rows_with({{"official", 1, 1, 2, 3, 6},
                    {"official", 2, 0, 1, 5, 8},
                    {"official", 3, 1, 2, 4, 7},
                    {"long", 1, 1, 1, 1, 5},
                    {"long", 2, 0, 1, 2, 6},
                    {"long", 3, 1, 2, 0, 7}});
}

RuleEffects effects_of_rows(const RowsById& rows) {
  return rule_effects_of(*small_rules().as<RulesExperiment>(), rows);
}

const RuleEffect& effect_on(const RuleEffects& all, const std::string& measure,
                            const std::string& variant) {
  for (const RuleEffect& effect : all.effects)
    if (effect.measure == measure && effect.variant == variant) return effect;
  throw std::logic_error("no effect on " + measure);
}

TEST(RuleEffects, AreMeansOverPairsAndDifferencesFromTheFirstVariant) {
  const RuleEffects all = effects_of_rows(three_pairs());
  EXPECT_DOUBLE_EQ(*effect_on(all, "goals", "official").mean, (3 + 1 + 3) / 3.0);
  EXPECT_DOUBLE_EQ(*effect_on(all, "goals", "long").mean, 2);
  const RuleEffect& touches = effect_on(all, "calls_attacker_double_touched_ball", "long");
  EXPECT_EQ(touches.pairs, 3U);
  EXPECT_DOUBLE_EQ(*touches.mean, 1);
  // Differences of -2, -3 and -4: mean -3, standard deviation 1, t(0.975, 2) = 4.303.
  EXPECT_DOUBLE_EQ(*touches.from_first.mean, -3);
  ASSERT_TRUE(touches.from_first.interval);
  EXPECT_NEAR(touches.from_first.interval->low, -3 - 4.303 / std::sqrt(3), 1e-3);
  EXPECT_FALSE(effect_on(all, "goals", "official").from_first.mean);
}

TEST(RuleEffects, DivideByTheTimeInPlayAndByTheCalls) {
  const RuleEffects all = effects_of_rows(three_pairs());
  EXPECT_DOUBLE_EQ(*effect_on(all, "stops_per_min", "official").mean, 7);
  EXPECT_DOUBLE_EQ(*effect_on(all, "stops_per_min", "long").mean, 6);
  EXPECT_DOUBLE_EQ(*effect_on(all, "in_play_percent", "long").mean, 60);
  EXPECT_DOUBLE_EQ(*effect_on(all, "in_play_min", "long").mean, 1);
  EXPECT_DOUBLE_EQ(*effect_on(all, "shots", "long").mean, 3);
  // Goals and double touches: 6, 6 and 7 calls in a game of each pair, one of them doubtful.
  EXPECT_DOUBLE_EQ(*effect_on(all, "calls", "official").mean, 19 / 3.0);
  EXPECT_DOUBLE_EQ(*effect_on(all, "doubtful_percent", "official").mean,
                   100 * (1 / 6.0 + 1 / 6.0 + 1 / 7.0) / 3);
}

TEST(RuleEffects, GiveTheLeadOfTheTeamThatIsStrongerInAllGames) {
  const RuleEffects all = effects_of_rows(three_pairs());
  EXPECT_EQ(all.matchups, (std::vector<Matchup>{{"zone", "bold"}}));
  EXPECT_DOUBLE_EQ(*effect_on(all, "lead_of_stronger", "official").mean, 1);
  EXPECT_DOUBLE_EQ(*effect_on(all, "lead_of_stronger", "long").mean, 2 / 3.0);
}

// zone wins under one variant, bold under the other, by more; calm beats both.
TEST(RuleEffects, FindTheStrongerTeamOfEachMatchupOverAllVariants) {
  RowsById rows = rows_with({{"official", 1, 0, 1}, {"long", 1, 3, 0}});
  RulesExperiment rules = *small_rules().as<RulesExperiment>();
  rules.teams["calm"] = {};
  for (const std::string other : {"bold", "zone"}) {
    GameRow row = rows.begin()->second;
    row.game_id = "official+" + other + "-calm";
    row.team_a = other == "zone" ? "calm" : other;
    row.team_b = other == "zone" ? other : "calm";
    row.record.goals_a = other == "zone" ? 2 : 0;
    row.record.goals_b = other == "zone" ? 0 : 2;
    rows[row.game_id] = row;
  }
  EXPECT_EQ(rule_effects_of(rules, rows).matchups,
            (std::vector<Matchup>{{"calm", "bold"}, {"bold", "zone"}, {"calm", "zone"}}));
}

TEST(RuleEffects, LeaveOutPairsWithVoidOrMissingGames) {
  RowsById rows = three_pairs();
  rows.at("long+bold~zone-p0002-1").record = void_record("a test");
  rows.erase("official+bold~zone-p0003-2");
  const RuleEffects all = effects_of_rows(rows);
  EXPECT_EQ(all.void_games, 1);
  EXPECT_EQ(effect_on(all, "goals", "official").pairs, 2U);
  EXPECT_EQ(effect_on(all, "goals", "long").pairs, 2U);
  EXPECT_EQ(effect_on(all, "goals", "long").from_first.pairs, 1U);
  EXPECT_FALSE(effect_on(all, "goals", "long").from_first.interval);
}

// Holm multiplies the smallest p by the number of tests, here of several measures.
TEST(RuleEffects, CorrectOverTheWholeTable) {
  const RuleEffects all = effects_of_rows(three_pairs());
  std::vector<PairedDifference> tests;
  for (const RuleEffect& effect : all.effects)
    if (effect.from_first.p) tests.push_back(effect.from_first);
  ASSERT_GT(tests.size(), 3U);
  const auto smallest = std::min_element(tests.begin(), tests.end(),
                                         [](const auto& x, const auto& y) { return *x.p < *y.p; });
  EXPECT_NEAR(*smallest->p_holm, static_cast<double>(tests.size()) * *smallest->p, 1e-12);
}

TEST(RuleEffects, OfNoGamesAreEmpty) {
  const RuleEffects all = effects_of_rows({});
  EXPECT_FALSE(effect_on(all, "goals", "official").mean);
  EXPECT_NE(io::text_of(table_of(all)).find("goals"), std::string::npos);
}

TEST(RulesTable, ShowsVariantsSideBySideWithoutRareCalls) {
  RowsById rows = three_pairs();
  // Two goal kicks in one leg of 3 pairs: 0.33 per game.
  rows.at("long+bold~zone-p0001-1")
      .record.events[static_cast<std::size_t>(referee::Event::kGoalKick)] = 2;
  const std::string text = io::text_of(table_of(effects_of_rows(rows)));
  EXPECT_NE(text.find("attacker_double_touched_ball"), std::string::npos) << text;
  EXPECT_NE(text.find("-3.00 ± 2.48"), std::string::npos) << text;
  EXPECT_NE(text.find("goal_kick"), std::string::npos) << text;
  EXPECT_NE(text.find("the stronger team first: zone against bold."), std::string::npos) << text;
  EXPECT_NE(text.find("long (3 pairs): match.rule.dribbling_m=2.0\n"), std::string::npos) << text;
}

// In 20 pairs, double touches fall by 2 or 3 per game. In four pairs each, there is one stop fewer
// or one goal more; these differences have a p below 0.05 only without the correction.
TEST(RulesTable, MarksOnlyDifferencesThatRemainAfterTheCorrection) {
  RowsById rows;
  for (int pair = 1; pair <= 20; ++pair) {
    add_legs({"official", pair, 1, 1, 5, 10}, rows);
    add_legs({"long", pair, pair > 16 ? 2 : 1, 1, 3 - pair % 2, pair <= 4 ? 9 : 10}, rows);
  }
  const RuleEffects all = effects_of_rows(rows);
  const PairedDifference& stops = effect_on(all, "stops_per_min", "long").from_first;
  EXPECT_LT(*stops.p, 0.05);
  EXPECT_GT(*stops.p_holm, 0.05);
  const std::string text = io::text_of(table_of(all));
  EXPECT_NE(text.find("-0.20 ± 0.19\n"), std::string::npos) << text;
  EXPECT_NE(text.find("-2.50 ± 0.24*\n"), std::string::npos) << text;
}

TEST(RulesTable, HasTwoVariantsBesidesTheFirst) {
  RulesExperiment rules = *small_rules().as<RulesExperiment>();
  rules.variants.push_back({"wide", {}});
  rules.variants.push_back({"short", {}});
  const io::TextBlocks blocks = table_of(rule_effects_of(rules, three_pairs()));
  std::vector<io::Cells> heads;
  for (const auto& block : blocks)
    if (const auto* table = std::get_if<io::TextTable>(&block)) heads.push_back(table->rows[0]);
  const std::string change = "from official ± 95 %";
  EXPECT_EQ(heads, (std::vector<io::Cells>{{"measure", "official", "long", change, "wide", change},
                                           {"measure", "official", "short", change}}));
}

TEST(RulesTable, LeavesRareCallsToTheCsv) {
  RowsById rows = three_pairs();
  for (int pair = 4; pair <= 20; ++pair) {
    for (const std::string variant : {"official", "long"}) add_legs({variant, pair, 0, 1}, rows);
  }
  rows.at("long+bold~zone-p0001-1")
      .record.events[static_cast<std::size_t>(referee::Event::kGoalKick)] = 1;  // 1 in 40 games
  const RuleEffects all = effects_of_rows(rows);
  EXPECT_EQ(io::text_of(table_of(all)).find("goal_kick"), std::string::npos);
  EXPECT_NE(csv_of(all).find("calls_goal_kick"), std::string::npos);
}

TEST(RulesJson, HasTheColumnsOfTheCsv) {
  const io::Json all = json_of(effects_of_rows(three_pairs()));
  const auto found = std::find_if(all.begin(), all.end(), [](const io::Json& one) {
    return one["measure"] == "goals" && one["variant"] == "long";
  });
  ASSERT_NE(found, all.end());
  EXPECT_DOUBLE_EQ((*found)["mean"].get<double>(), 2);
  EXPECT_NEAR((*found)["from_first"].get<double>(), -1 / 3.0, 1e-12);
  EXPECT_TRUE(found->contains("from_first_low95"));
}

}  // namespace
}  // namespace autoref::experiments
