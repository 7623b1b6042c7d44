// "All opponent robots are at least 500 mm from the ball. ... If, when a free kick is taken, an
// opponent is closer to the ball than the required distance: the kick is retaken" (Laws 13); in
// 2026 such a robot commits a foul that does not stop play.
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kWest2{Side::kWest, 2};

// Puts west 2 south of the ball, so that its back is `gap_m` away.
void come_near(ScriptedGame& game, double gap_m) {
  const Vec2 from_ball_m(0, -gap_m - kRobotRadius_m);
  game.robot(Side::kWest, 2) = {2, game.frame.ball->position_m + from_ball_m, Vec2(0, -1)};
}

void take_kick(ScriptedGame& game) {
  game.kick(Side::kEast, 3, {-1, 0});
  game.run(0.2);
}

TEST(RestartDistance, At490MillimetresTheKickIsRetaken) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  const Vec2 ball_m = game.frame.ball->position_m;
  come_near(game, 0.49);
  take_kick(game);
  ASSERT_EQ(game.count("defender_too_close_to_kick_point"), 1);
  const Decision& again = game.decisions.back();
  EXPECT_NEAR(again.finding.value, 0.49, 1e-9);
  EXPECT_TRUE(is_foul_of(again, kWest2));
  EXPECT_EQ(again.finding.card, Card::kNone);
  EXPECT_EQ(again.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
  EXPECT_NEAR((game.signal.placement->target_m - ball_m).norm(), 0, 1e-9);
}

TEST(RestartDistance, ItsDetailsAreTheNearestRobots) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  come_near(game, 0.3);
  RobotObservation& farther = game.robot(Side::kWest, 1);
  farther = game.robot(Side::kWest, 2);
  farther.number = 1;
  farther.position_m += Vec2(0, -0.1);
  const Decision call = game.run_until("defender_too_close_to_kick_point", 0.2);
  EXPECT_EQ(call.finding.robots.size(), 2U);
  EXPECT_EQ(call.finding.details.robot, kWest2);
  EXPECT_EQ(call.finding.details.robot_m, game.robot(Side::kWest, 2).position_m);
}

TEST(RestartDistance, At510MillimetresPlayGoesOn) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  come_near(game, 0.51);
  take_kick(game);
  EXPECT_TRUE(game.referee.is_ball_in_play());
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 0);
}

// A violation seen in a single frame must exceed three standard deviations of the noise: here 15
// mm.
TEST(RestartDistance, WithinTheNoiseOfVisionPlayGoesOn) {
  for (const double gap_m : {0.48, 0.49}) {
    Configuration configuration = by_book("2014");
    configuration.noise = {0.004, 0.003, 0.01};
    ScriptedGame game = throw_in_game(configuration);
    come_near(game, gap_m);
    take_kick(game);
    EXPECT_EQ(game.count("defender_too_close_to_kick_point"), gap_m < 0.485 ? 1 : 0);
  }
}

TEST(RestartDistance, ARobotMayComeNearOnceTheBallIsInPlay) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  take_kick(game);
  come_near(game, 0.1);
  game.run(1);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 0);
}

TEST(RestartDistance, TheKickersTeamMatesMayBeNear) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  game.robot(Side::kEast, 4).position_m = game.frame.ball->position_m - Vec2(0, 0.2);
  take_kick(game);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 0);
}

// The Laws show a card to a robot that does not keep its distance when the restart is retaken.
TEST(RestartDistance, TheSameRobotGetsAYellowCardTheSecondTime) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  come_near(game, 0.3);
  take_kick(game);
  game.run_until("start");
  take_kick(game);
  ASSERT_EQ(game.count("defender_too_close_to_kick_point"), 2);
  EXPECT_EQ(game.signal.yellow_cards[Side::kWest], 1);
  EXPECT_EQ(game.signal.robots_allowed[Side::kWest], kMaxRobots - 1);
}

TEST(RestartDistance, AnotherRobotGetsNoCardTheSecondTime) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  come_near(game, 0.3);
  take_kick(game);
  game.run_until("start");
  game.robot(Side::kWest, 4).position_m = game.robot(Side::kWest, 2).position_m;
  game.robot(Side::kWest, 2).position_m = Vec2(-1.5, 0.6);
  take_kick(game);
  ASSERT_EQ(game.count("defender_too_close_to_kick_point"), 2);
  EXPECT_EQ(game.signal.yellow_cards[Side::kWest], 0);
}

// AutoRef's own limit: a team that always breaks the rule cannot hang a game.
TEST(RestartDistance, ARestartIsRetakenAtMostThreeTimes) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  come_near(game, 0.3);
  for (int i = 0; i < 3; ++i) {
    take_kick(game);
    game.run_until("start");
  }
  take_kick(game);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 3);
  EXPECT_TRUE(game.referee.is_ball_in_play());
}

TEST(RestartDistance, AKickOffIsPreparedAgain) {
  ScriptedGame game(by_book("2014"));
  game.line_up().kick_off();
  game.robot(Side::kEast, 2) = {2, {0.4, 0}, Vec2(-1, 0)};
  game.kick(Side::kWest, 1, {0, 2});
  const Decision again = game.run_until("defender_too_close_to_kick_point", 1);
  EXPECT_EQ(again.restart(), (Command{CommandKind::kPrepareKickoff, Side::kWest}));
  EXPECT_EQ(game.run_until("prepare").command, again.restart());
}

TEST(RestartDistance, In2026ItIsAFoulAtOnceAndAgainAfterTwoSeconds) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  come_near(game, 0.49);
  const double since_s = game.now_s();
  const Decision foul = game.run_until("defender_too_close_to_kick_point", 5);
  EXPECT_NEAR(foul.time_s - since_s, 0, 0.05);
  EXPECT_TRUE(is_foul_of(foul, kWest2));
  game.run(1.9);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 1);
  game.run(0.2);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 2);
  EXPECT_EQ(game.referee.state(), State::kRun);
}

TEST(RestartDistance, In2026ItIsNotAFoulAt510Millimetres) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  come_near(game, 0.51);
  game.run(4);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point"), 0);
}

TEST(RestartDistance, In2026TheTimeForTheKickRestarts) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  game.run(5);
  come_near(game, 0.3);
  const double noted_s = game.run_until("defender_too_close_to_kick_point", 5).time_s;
  come_near(game, 0.6);
  EXPECT_NEAR(game.run_until("restart_not_taken", 30).time_s, noted_s + 10, 1e-6);
}

TEST(RestartDistance, IsNotARuleOfThePaper) {
  ScriptedGame game = throw_in_game(Configuration{});
  come_near(game, 0.1);
  game.run(3);
  take_kick(game);
  EXPECT_EQ(game.count("defender_too_close_to_kick_point") +
                game.count("defender_too_close_to_kick_point"),
            0);
}

}  // namespace
}  // namespace autoref::referee
