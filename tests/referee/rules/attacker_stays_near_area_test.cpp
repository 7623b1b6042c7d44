// "During stop and free kicks, before the ball has entered play, all robots have to keep at least
// 0.2 meters distance to the opponent defense area. There is a grace period of 2 seconds" (2026).
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kAttacker{Side::kWest, 2};
// Division B: goal lines at 4.5 m, areas 1 m deep.
constexpr double kAreaEdge_m = 4.5 - 1.0;

// A robot facing its own goal, with its round back `gap_m` from the opponents' area.
RobotObservation near_area(Side side, int number, double gap_m) {
  const double towards = -goal_sign(side);
  return {number, {towards * (kAreaEdge_m - gap_m - kRobotRadius_m), 0}, Vec2(-towards, 0)};
}

// The ball is never placed, so the stop lasts.
ScriptedGame long_stop(std::string_view book) {
  ScriptedGame game = stopped_game(by_book(book));
  game.placement_works = false;
  game.put_ball({0, 0});
  return game;
}

int fouls(const ScriptedGame& game) { return game.count("attacker_stays_near_area"); }

TEST(AttackerStaysNearArea, IsCalledAt190MillimetresAfterTwoSeconds) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.19);
  const double since_s = game.now_s();
  const Decision foul = game.run_until("attacker_stays_near_area", 5);
  EXPECT_EQ(foul.to, State::kWaitStop);
  EXPECT_NEAR(foul.time_s - since_s, 2, 0.05);
  EXPECT_NEAR(foul.finding.value, 0.19, 1e-9);
  EXPECT_TRUE(is_foul_of(foul, kAttacker));
}

TEST(AttackerStaysNearArea, IsNotCalledAt210Millimetres) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.21);
  game.run(6);
  EXPECT_EQ(fouls(game), 0);
}

TEST(AttackerStaysNearArea, IsNotCalledForARobotThatLeavesInTime) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.run(1.9);
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.3);
  game.run(3);
  EXPECT_EQ(fouls(game), 0);
}

TEST(AttackerStaysNearArea, GivesTheOpponentsAFreeKickFromTheBallsPosition) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.put_ball({0, -1});
  const Decision foul = game.run_until("attacker_stays_near_area", 5);
  EXPECT_EQ(foul.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(0, -1)).norm(), 0, 1e-9);
}

TEST(AttackerStaysNearArea, IsCalledAtOnceInTheFreeKickAfterTheStop) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  const double since_s = game.now_s();
  const Decision foul = game.run_until("attacker_stays_near_area", 5);
  EXPECT_NEAR(foul.time_s - since_s, 0, 0.05);
  EXPECT_EQ(foul.from, State::kRun);
  EXPECT_EQ(foul.to, State::kWaitStop);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kStop);
}

TEST(AttackerStaysNearArea, HaltsTheGameBrieflyTheSecondTime) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  const double first_s = game.run_until("attacker_stays_near_area", 5).time_s;
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 1);
  game.robot(Side::kWest, 3) = near_area(Side::kWest, 3, 0.1);
  game.run(1.9);
  EXPECT_EQ(fouls(game), 1);
  game.run(0.2);
  ASSERT_EQ(fouls(game), 2);
  const Decision& second = game.decisions.back();
  EXPECT_NEAR(second.time_s - first_s, 2, 0.05);
  EXPECT_EQ(second.to, State::kDelayWait);
  EXPECT_EQ(second.command, (Command{CommandKind::kHalt, Side::kWest}));
  game.robot(Side::kWest, 3) = near_area(Side::kWest, 3, 1);
  game.placement_works = true;
  game.run_until("signalled", 3);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kStop);
  EXPECT_EQ(game.run_until("start", 20).command, (Command{CommandKind::kDirectFree, Side::kEast}));
}

TEST(AttackerStaysNearArea, HaltsTheGameAfterTheBooksNumberOfFouls) {
  for (const int fouls_per_halt : {1, 3}) {
    Configuration configuration = by_book("2026-b");
    configuration.rules.area_fouls_per_halt = fouls_per_halt;
    configuration.rules.halt_s = 5;
    ScriptedGame game = throw_in_game(configuration);
    game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
    game.placement_works = false;
    while (game.signal.command.kind != CommandKind::kHalt && game.now_s() < 60) game.run(0.1);
    EXPECT_EQ(fouls(game), fouls_per_halt);
    const double halted_s = game.signal.command_time_s;
    EXPECT_NEAR(game.run_until("signalled", 10).time_s - halted_s, 5, 0.05);
  }
}

TEST(AttackerStaysNearArea, CountsTheSecondFoulAfterTheFirstStoppedAFreeKick) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.placement_works = false;
  game.run_until("attacker_stays_near_area", 1);
  game.run(2.2);
  ASSERT_EQ(fouls(game), 2);
  EXPECT_EQ(game.decisions.back().to, State::kDelayWait);
}

TEST(AttackerStaysNearArea, IsAFoulByBothSidesInOneFrameWithoutChangingTheRestart) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.robot(Side::kEast, 2) = near_area(Side::kEast, 2, 0.1);
  const std::optional<Command> next = game.signal.next_command;
  const Decision foul = game.run_until("attacker_stays_near_area", 5);
  EXPECT_EQ(foul.to, State::kWaitStop);
  EXPECT_FALSE(foul.finding.offender.has_value());
  EXPECT_EQ(foul.finding.robots.size(), 2U);
  EXPECT_EQ(game.signal.next_command, next);
}

TEST(AttackerStaysNearArea, IsNotCalledOnceTheBallIsInPlay) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  game.kick(Side::kEast, 3, {0, -1});
  game.run(0.2);
  ASSERT_TRUE(game.referee.is_ball_in_play());
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.run(3);
  EXPECT_EQ(fouls(game) + game.count("attacker_too_close_to_defense_area"), 0);
}

TEST(AttackerStaysNearArea, IsNotARuleOfTheLaws) {
  ScriptedGame game = long_stop("2014");
  game.robot(Side::kWest, 2).position_m = Vec2(2.1, 0);
  game.run(4);
  EXPECT_EQ(fouls(game), 0);
}

}  // namespace
}  // namespace autoref::referee
