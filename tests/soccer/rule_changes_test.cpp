// How a game's rules differ from the official ones, and which numbers contradict each other.
#include "soccer/rules/rule_changes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace autoref {
namespace {

struct ChangedGame {
  explicit ChangedGame(const std::string& book)
      : rules(find_rule_book(book).value()), field(find_game_setup(book)->field) {}
  std::string text() const { return not_official_text(text_of(rule_changes(rules, field))); }
  // The path and text of the contradiction; empty if there is none.
  std::string refusal() const {
    try {
      check_rules(rules, field);
    } catch (const OutOfRange& error) {
      return error.what();
    }
    return "";
  }

  RuleBook rules;
  Field field;
};

TEST(RuleChanges, OfOfficialBooksAreNone) {
  for (const std::string& book : rule_book_names()) {
    EXPECT_EQ(ChangedGame(book).text(), "") << book;
    EXPECT_EQ(ChangedGame(book).refusal(), "") << book;
  }
}

// A user who writes an official value has changed nothing.
TEST(RuleChanges, AreNoneIfEveryNumberIsReadFromItsText) {
  for (const std::string& book : rule_book_names()) {
    ChangedGame game(book);
    RuleBook::visit(game.rules, [](auto& number, const Parameter& about) {
      const std::string text = fmt::format("{}", number);
      if constexpr (std::is_same_v<std::remove_reference_t<decltype(number)>, double>)
        number = std::stod(text);
      EXPECT_EQ(fmt::format("{}", number), text) << about.name;
    });
    EXPECT_EQ(game.text(), "") << book;
  }
}

TEST(RuleChanges, NameTheValueAndTheOfficialOne) {
  ChangedGame game("2026-b");
  game.rules.double_touch_m = 0.15;
  EXPECT_EQ(game.text(), "not the official rules: double touch 150 mm (50)");
  game.rules.dribbling_m = 0.5;
  game.rules.kick_limit_mps = 8;
  game.rules.fouls_per_card = 0;
  game.rules.clock_stops = false;
  game.rules.in_force[RuleId::kOffside] = true;
  game.field.defence_area.shape = DefenceArea::Shape::kQuarterCircles;
  EXPECT_EQ(game.text(),
            "not the official rules: double touch 150 mm (50); kick limit 8 m/s (6.5); dribbling "
            "0.5 m (1); fouls per card 0 (3); clock stops no (yes); offside yes (no); defence "
            "area shape quarter circles (box)");
}

TEST(RuleChanges, HaveThePathsOfTheirSettings) {
  ChangedGame game("2026-b");
  game.rules.double_touch_m = 0.15;
  game.rules.change_ends = false;
  game.rules.in_force[RuleId::kOffside] = true;
  game.field.goal_width_m = 1.2;
  std::vector<std::string> paths;
  for (const RuleChange& change : rule_changes(game.rules, game.field))
    paths.push_back(change.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"match.rule.double_touch_m", "match.change_ends",
                                             "match.switch.offside", "field.goal_width_m"}));
}

TEST(RuleContradictions, AreRefusedByTheNumberToCorrect) {
  const auto refusal = [](double RuleBook::*number, double value) {
    ChangedGame game("2026-b");
    game.rules.*number = value;
    return game.refusal();
  };
  EXPECT_EQ(
      refusal(&RuleBook::double_touch_m, 0.02),
      "in_play_m is 0.05; it must be at most double_touch_m (0.02), because a second touch is "
      "a foul only once the ball is in play");
  EXPECT_EQ(refusal(&RuleBook::double_touch_m, 0.05), "");
  EXPECT_TRUE(refusal(&RuleBook::readiness_period_s, 20).starts_with("readiness_period_s is 20"));
  EXPECT_TRUE(refusal(&RuleBook::attacker_to_area_m, 1.1).starts_with("attacker_to_area_m is 1.1"));
  EXPECT_TRUE(refusal(&RuleBook::placement_least_s, 31).starts_with("placement_least_s is 31"));
  EXPECT_TRUE(refusal(&RuleBook::start_timeout_s, 0.5).starts_with("readiness_period_s is 1"));
  EXPECT_TRUE(refusal(&RuleBook::ball_in_position_m, 0.16).starts_with("ball_in_position_m"));
}

// The half of division B's field is 4.5 m by 3 m, and its areas are 1 m deep.
TEST(RuleContradictions, LeaveRoomForRestartsOnTheField) {
  const auto refusal = [](double RuleBook::*number, double value) {
    ChangedGame game("2026-b");
    game.rules.*number = value;
    return game.refusal();
  };
  EXPECT_EQ(refusal(&RuleBook::neutral_to_area_m, 3.5), "");
  EXPECT_NE(refusal(&RuleBook::neutral_to_area_m, 3.6), "");
  // Free kicks next to an area are 0.2 m or more from the touch line, and the areas are 2 m wide.
  EXPECT_EQ(refusal(&RuleBook::free_kick_to_area_m, 1.8), "");
  EXPECT_NE(refusal(&RuleBook::free_kick_to_area_m, 1.9), "");
  EXPECT_EQ(refusal(&RuleBook::penalty_clearance_m, 3), "");
  EXPECT_NE(refusal(&RuleBook::penalty_clearance_m, 3.1), "");
  ChangedGame narrow("2026-b");
  narrow.field.width_m = 2;
  EXPECT_EQ(narrow.refusal(), "") << "official numbers are valid on any field";
  narrow.rules.in_force[RuleId::kOffside] = true;
  narrow.rules.dribbling_m = 0.5;
  EXPECT_EQ(narrow.refusal(), "") << "the numbers that need room are official";
  narrow.rules.throw_in_inset_m = 1.1;
  EXPECT_NE(narrow.refusal(), "");
}

}  // namespace
}  // namespace autoref
