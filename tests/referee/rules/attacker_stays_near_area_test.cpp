// "During stop and free kicks, before the ball has entered play, all robots have to keep at least
// 0.2 meters distance to the opponent defense area. There is a grace period of 2 seconds" (2026).
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kWest2{Side::kWest, 2};
// Division B: goal lines at 4.5 m, areas 1 m deep.
constexpr double kAreaEdge_m = 4.5 - 1.0;

// A robot that faces its own goal, its round back `gap_m` from the opponents' area.
RobotObservation near_area(Side side, int number, double gap_m) {
  const double towards = -goal_sign(side);
  return {number, {towards * (kAreaEdge_m - gap_m - kRobotRadius_m), 0}, Vec2(-towards, 0)};
}

// Nobody brings the ball to its place, so that the stop lasts.
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
  EXPECT_TRUE(is_foul_of(foul, kWest2));
}

TEST(AttackerStaysNearArea, IsNotCalledAt210Millimetres) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.21);
  game.run(6);
  EXPECT_EQ(fouls(game), 0);
}

TEST(AttackerStaysNearArea, IsNotCalledOfARobotThatLeavesInTime) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.run(1.9);
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.3);
  game.run(3);
  EXPECT_EQ(fouls(game), 0);
}

TEST(AttackerStaysNearArea, IsCalledOncePerRobotAndStopWithTheFreeKickAfterIt) {
  ScriptedGame game = stopped_game(by_book("2026-b"));
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.run_until("start");
  game.run(5);
  ASSERT_EQ(game.signal.command.kind, CommandKind::kDirectFree);
  EXPECT_EQ(fouls(game), 1);
}

TEST(AttackerStaysNearArea, OfBothSidesInOneFrameIsAFoulOfBoth) {
  ScriptedGame game = long_stop("2026-b");
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.robot(Side::kEast, 2) = near_area(Side::kEast, 2, 0.1);
  const Decision foul = game.run_until("attacker_stays_near_area", 5);
  EXPECT_EQ(foul.to, State::kWaitStop);
  EXPECT_FALSE(foul.finding.offender.has_value());
  EXPECT_EQ(foul.finding.robots.size(), 2U);
  game.run(3);
  EXPECT_EQ(fouls(game), 1);
}

TEST(AttackerStaysNearArea, IsNoCallOnceTheBallIsInPlay) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  game.robot(Side::kWest, 2) = near_area(Side::kWest, 2, 0.1);
  game.kick(Side::kEast, 3, {0, -1});
  game.run(3);
  EXPECT_EQ(fouls(game) + game.count("attacker_too_close_to_defense_area"), 0);
}

TEST(AttackerStaysNearArea, IsNoRuleOfTheLaws) {
  ScriptedGame game = long_stop("2014");
  game.robot(Side::kWest, 2).position_m = Vec2(2.1, 0);
  game.run(4);
  EXPECT_EQ(fouls(game), 0);
}

}  // namespace
}  // namespace autoref::referee
