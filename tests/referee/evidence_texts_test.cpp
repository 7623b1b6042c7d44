// Distances and cards in the evidence of findings.
#include <gtest/gtest.h>

#include "referee/finding.hpp"
#include "referee/machine/cards.hpp"

namespace autoref::referee {
namespace {

TEST(EvidenceTexts, NameARobotByItsColour) {
  EXPECT_EQ(text_of({Side::kWest, 3}), "yellow 3");
  EXPECT_EQ(text_of({Side::kEast, 11}), "blue 11");
}

TEST(EvidenceTexts, SayInsideInsteadOfANegativeDistance) {
  EXPECT_EQ(gap_text(0.083), "83 mm from");
  EXPECT_EQ(gap_text(-0.367), "367 mm inside");
}

TEST(EvidenceTexts, ShowZeroForBodiesThatTouch) {
  EXPECT_EQ(mm_text(0.5), "500 mm");
  EXPECT_EQ(mm_text(-0.005), "0 mm");
  EXPECT_EQ(mm_text(-0.0002), "0 mm");
}

struct Shown {
  Event event = Event::kMultipleFouls;
  double fouls = 3;
  int active_yellows = 0;
  Card card = Card::kYellow;
};

std::string reason_of(const Shown& shown) {
  const RuleBook rules = *find_rule_book("2026-b");
  PerSide<CardBook> cards;
  for (int i = 0; i < shown.active_yellows; ++i) cards[Side::kEast].yellow_ends_s.push_back(99);
  Finding finding;
  finding.event = shown.event;
  finding.value = shown.fouls;
  finding.offender = Side::kEast;
  return card_reason(cards, finding, shown.card, rules);
}

TEST(CardReason, SaysWhichFoulBroughtTheCard) {
  EXPECT_EQ(reason_of({}), "3rd foul (every 3rd brings a card)");
  EXPECT_EQ(reason_of({.fouls = 12}), "12th foul (every 3rd brings a card)");
  EXPECT_EQ(reason_of({.fouls = 21}), "21st foul (every 3rd brings a card)");
}

TEST(CardReason, SaysWhichActiveYellowCardIsRed) {
  EXPECT_EQ(
      reason_of({Event::kMultipleCards, 9, 2, Card::kRed}),
      "9th foul (every 3rd brings a card); red because it would be the 3rd active yellow card");
}

TEST(CardReason, NamesAnOffenceThatBringsACardByItself) {
  EXPECT_EQ(reason_of({.event = Event::kDefenderInDefenseAreaPartially}),
            "a defender played the ball partly inside its own area");
  EXPECT_EQ(reason_of({.event = Event::kTooManyRobots}), "too many robots");
}

}  // namespace
}  // namespace autoref::referee
