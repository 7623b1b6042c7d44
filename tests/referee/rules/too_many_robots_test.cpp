// Robots that stay on the field after a card (2026 rules: for more than ten seconds).
#include <gtest/gtest.h>

#include "referee/rules/rule.hpp"
#include "tests/referee/machine/staged_machine.hpp"

namespace autoref::referee {
namespace {

Configuration six_each() {
  Configuration configuration;
  configuration.rules = *find_rule_book("2026-b");
  configuration.field = find_game_setup("2026-b")->field;
  configuration.robots = {{6, 6}};
  return configuration;
}

StagedMachine with_robots(State state = State::kRun) {
  StagedMachine game(six_each(), state);
  game.line_up(6);
  return game;
}

// Looks ten times a second. Returns the label of the first transition taken, empty if there was
// none.
std::string_view look_for(StagedMachine& game, double seconds) {
  const double end_s = game.now_s() + seconds - 1e-9;
  while (game.now_s() < end_s) {
    game.wait(0.1);
    const std::string_view label = game.look_for(kTooManyRobotsRule);
    if (!label.empty()) return label;
  }
  return {};
}

TEST(TransitionTooManyRobots, GivesAForceStartTenSecondsAfterACardAndNoFoul) {
  StagedMachine game = with_robots();
  game.fouls_for_cards(Side::kEast, 1);
  EXPECT_EQ(look_for(game, 9.9), "");
  EXPECT_EQ(look_for(game, 0.1), "too_many_robots");
  EXPECT_EQ(game.state.machine_state, State::kWaitStop);
  EXPECT_EQ(game.state.signal.next_command->kind, CommandKind::kForceStart);
  EXPECT_EQ(game.state.cards[Side::kEast].fouls, 3);
}

TEST(TransitionTooManyRobots, SaysHowManyRobotsThereAreAndMayBe) {
  StagedMachine game = with_robots();
  game.fouls_for_cards(Side::kEast, 1);
  look_for(game, 10);
  EXPECT_EQ(game.last_found.details.robots, 6);
  EXPECT_EQ(game.last_found.details.robots_allowed, 5);
}

TEST(TransitionTooManyRobots, IsTakenOncePerCard) {
  StagedMachine game = with_robots();
  game.fouls_for_cards(Side::kEast, 1);
  look_for(game, 10);
  EXPECT_EQ(look_for(game, 10), "");
  game.foul(Side::kEast);
  game.foul(Side::kEast);
  game.foul(Side::kEast);
  ASSERT_EQ(game.look_for_cards(), "multiple_fouls");
  EXPECT_EQ(look_for(game, 10), "too_many_robots");
}

// Division B: the field is 9 m long, so a robot of 180 mm at 4.6 m is beyond the goal line.
TEST(TransitionTooManyRobots, IsNotTakenIfARobotHasLeft) {
  for (const double x_m : {4.58, 4.6}) {
    StagedMachine game = with_robots();
    game.fouls_for_cards(Side::kEast, 1);
    game.robot(Side::kEast, 5).position_m = Vec2(x_m, 2);
    EXPECT_EQ(look_for(game, 10), x_m < 4.59 ? "too_many_robots" : "") << x_m;
  }
}

TEST(TransitionTooManyRobots, LeadsToAForceStartIfBothSidesAreAtFault) {
  StagedMachine game = with_robots();
  for (int i = 0; i < 3; ++i) game.foul(std::nullopt);
  game.look_for_cards();
  look_for(game, 10);
  EXPECT_EQ(game.state.signal.next_command->kind, CommandKind::kForceStart);
}

TEST(TransitionTooManyRobots, IsTakenTwoSecondsAfterAStartWithoutACard) {
  StagedMachine game = with_robots();
  game.line_up(7);
  game.state.play.began_s = game.now_s();
  EXPECT_EQ(look_for(game, 1.9), "");
  EXPECT_EQ(look_for(game, 0.2), "too_many_robots");
}

TEST(TransitionTooManyRobotsStopped, LeavesTheRestartAsItIs) {
  StagedMachine game = with_robots(State::kWaitStop);
  game.fouls_for_cards(Side::kWest, 1);
  EXPECT_EQ(look_for(game, 10), "too_many_robots");
  EXPECT_EQ(game.state.cards[Side::kWest].fouls, 3);
  EXPECT_FALSE(game.state.signal.next_command.has_value());
}

}  // namespace
}  // namespace autoref::referee
