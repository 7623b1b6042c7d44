// One test suite per transition of cards.
#include <gtest/gtest.h>

#include "soccer/rules/rule_book.hpp"
#include "tests/referee/machine/staged_machine.hpp"

namespace autoref::referee {
namespace {

Configuration with_cards(std::string_view book) {
  Configuration configuration;
  configuration.rules = *find_rule_book(book);
  configuration.robots = {{6, 6}};
  return configuration;
}

StagedMachine in_2026(State state = State::kRun) {
  return StagedMachine(with_cards("2026-b"), state);
}

// "Every third foul of the same team results in a yellow card" (2026).
TEST(TransitionMultipleFouls, IsTakenAtTheThirdFoulWithoutStoppingPlay) {
  StagedMachine game = in_2026();
  EXPECT_EQ(game.foul(Side::kEast), "bot_crash_unique");
  EXPECT_EQ(game.look_for_cards(), "");
  game.foul(Side::kEast);
  EXPECT_EQ(game.look_for_cards(), "");
  game.foul(Side::kEast);
  EXPECT_EQ(game.look_for_cards(), "multiple_fouls");
  EXPECT_EQ(game.state.machine_state, State::kRun);
  EXPECT_EQ(game.state.signal.yellow_cards, (PerSide<int>{{0, 1}}));
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{6, 5}}));
  EXPECT_EQ(game.state.signal.command_counter, 0U);
}

TEST(TransitionMultipleFouls, IsTakenOnceForThreeFouls) {
  StagedMachine game = in_2026();
  game.fouls_for_cards(Side::kWest, 1);
  EXPECT_EQ(game.look_for_cards(), "");
  EXPECT_EQ(game.state.signal.yellow_cards[Side::kWest], 1);
}

TEST(TransitionMultipleFouls, CountsEachSidesFoulsSeparately) {
  StagedMachine game = in_2026();
  game.fouls(Side::kWest, 2);
  game.fouls(Side::kEast, 2);
  EXPECT_EQ(game.look_for_cards(), "");
}

// A drawn crash may be the third foul of both sides; then both get the card at once.
TEST(TransitionMultipleFouls, IsTakenForBothSidesAtOnce) {
  StagedMachine game = in_2026();
  game.fouls(std::nullopt, 3);
  EXPECT_EQ(game.look_for_cards(), "multiple_fouls");
  EXPECT_EQ(game.state.signal.yellow_cards, (PerSide<int>{{1, 1}}));
  EXPECT_EQ(game.look_for_cards(), "");
}

TEST(TransitionMultipleFoulsStopped, IsTakenWhilePlayIsStopped) {
  StagedMachine game = in_2026(State::kWaitStop);
  game.fouls(Side::kWest, 3);
  EXPECT_EQ(game.look_for_cards(), "multiple_fouls");
  EXPECT_EQ(game.state.machine_state, State::kWaitStop);
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{5, 6}}));
}

// "When a team has two not yet expired yellow cards and receives another yellow card, this card
// will be turned into a red card instead" (2026).
TEST(TransitionMultipleCards, IsTakenForTheThirdActiveYellowCard) {
  StagedMachine game = in_2026();
  game.fouls_for_cards(Side::kWest, 2);
  game.fouls(Side::kWest, 3);
  EXPECT_EQ(game.look_for_cards(), "multiple_cards");
  EXPECT_EQ(game.state.signal.yellow_cards[Side::kWest], 2);
  EXPECT_EQ(game.state.signal.red_cards, (PerSide<int>{{1, 0}}));
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{3, 6}}));
}

TEST(TransitionMultipleCards, IsNotTakenIfAnEarlierYellowCardIsOver) {
  StagedMachine game = in_2026();
  game.fouls_for_cards(Side::kWest, 1);
  game.wait(120);
  game.fouls_for_cards(Side::kWest, 2);
  EXPECT_EQ(game.state.signal.red_cards[Side::kWest], 0);
  EXPECT_EQ(game.state.signal.yellow_cards[Side::kWest], 3);
}

TEST(TransitionMultipleCards, LastsForTheRestOfTheGame) {
  StagedMachine game = in_2026();
  game.fouls_for_cards(Side::kWest, 3);
  game.wait(3600);
  while (!game.look_for_cards().empty()) continue;
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{5, 6}}));
}

TEST(TransitionMultipleCardsStopped, IsTakenWhilePlayIsStopped) {
  StagedMachine game = in_2026(State::kWaitStop);
  game.fouls_for_cards(Side::kEast, 2);
  game.fouls(Side::kEast, 3);
  EXPECT_EQ(game.look_for_cards(), "multiple_cards");
  EXPECT_EQ(game.state.signal.red_cards, (PerSide<int>{{0, 1}}));
}

// A yellow card lasts for two minutes of play (Laws 12; 2026).
TEST(TransitionCardOver, IsTakenAfterTwoMinutesOfPlay) {
  StagedMachine game = in_2026();
  game.fouls_for_cards(Side::kEast, 1);
  game.wait(119.9);
  EXPECT_EQ(game.look_for_cards(), "");
  game.wait(0.1);
  EXPECT_EQ(game.look_for_cards(), "card_over");
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{6, 6}}));
  EXPECT_EQ(game.state.signal.yellow_cards[Side::kEast], 1);  // cards shown so far
}

TEST(TransitionCardOver, DoesNotCountTimeWhilePlayIsStopped) {
  StagedMachine game = in_2026();
  game.fouls_for_cards(Side::kEast, 1);
  game.wait(100);
  Finding out;
  out.event = Event::kThrowIn;
  out.restart = {CommandKind::kDirectFree, Side::kWest};
  ASSERT_EQ(game.put(out), "throw_in");
  game.wait(100);
  Finding ready;
  ready.event = Event::kReady;
  ASSERT_EQ(game.put(ready), "start");
  game.wait(19.9);
  EXPECT_EQ(game.look_for_cards(), "");
  game.wait(0.1);
  EXPECT_EQ(game.look_for_cards(), "card_over");
}

Finding carded_foul(Card card) {
  Finding finding;
  finding.event = Event::kDefenderInDefenseAreaPartially;
  finding.offender = Side::kWest;
  finding.card = card;
  finding.restart = {CommandKind::kIndirectFree, Side::kEast};
  return finding;
}

TEST(Cards, ShownByARuleRemoveARobot) {
  StagedMachine game(with_cards("2014"));
  game.put(carded_foul(Card::kYellow));
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{5, 6}}));
  EXPECT_EQ(game.state.signal.yellow_cards, (PerSide<int>{{1, 0}}));
}

TEST(Cards, AreNotShownIfTheirRuleIsSwitchedOff) {
  Configuration configuration = with_cards("2014");
  configuration.rules.in_force[RuleId::kCards] = false;
  StagedMachine game(configuration);
  game.put(carded_foul(Card::kRed));
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{6, 6}}));
  EXPECT_EQ(game.state.signal.red_cards, (PerSide<int>{{0, 0}}));
}

TEST(Cards, LeaveATeamItsLastRobot) {
  Configuration configuration = with_cards("2026-b");
  configuration.robots = {{2, 2}};
  StagedMachine game(configuration);
  game.fouls_for_cards(Side::kWest, 5);
  EXPECT_EQ(game.state.signal.robots_allowed, (PerSide<int>{{1, 2}}));
}

}  // namespace
}  // namespace autoref::referee
