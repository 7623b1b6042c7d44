// The last touch across a gap in vision: known, with less confidence, if the ball shows it.
#include "referee/touch/kept_touch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kYellow1{Side::kWest, 1};

// A game in which yellow 1 has the ball at its dribbler, far from all others.
ScriptedGame yellow_has_the_ball() {
  ScriptedGame game = in_play();
  game.kick(kYellow1.side, kYellow1.number, {0, 1.5});
  game.ball_mps = Vec2(0, 0);
  return game;
}

// Nothing is seen for `gap_s`, and the ball moves on meanwhile.
void skip_moving(ScriptedGame& game, double gap_s) {
  game.skip(gap_s);
  game.frame.ball->position_m += game.ball_mps * gap_s;
}

Decision exit_of(ScriptedGame& game) {
  for (int i = 0; i < 240; ++i) {
    const std::size_t former = game.decisions.size();
    game.step();
    for (std::size_t k = former; k < game.decisions.size(); ++k) {
      if (entry_of(game.decisions[k].finding.event).is_exit) return game.decisions[k];
    }
  }
  throw std::runtime_error("the ball never left");
}

TEST(KeptTouch, IsTheKickOfTheRobotThatHadTheBall) {
  ScriptedGame game = yellow_has_the_ball();
  game.ball_mps = Vec2(0.2, 1.5);
  const double confidence = [&] {
    ScriptedGame seen = yellow_has_the_ball();
    seen.ball_mps = Vec2(0.2, 1.5);
    return exit_of(seen).finding.confidence;
  }();
  skip_moving(game, 1.1);
  const Decision exit = exit_of(game);
  EXPECT_EQ(exit.finding.event, Event::kThrowIn);
  EXPECT_EQ(exit.restart()->side, Side::kEast);
  EXPECT_EQ(exit.last_touch.robot, kYellow1);
  EXPECT_GT(exit.last_touch.kept, 0.6);
  EXPECT_LT(exit.last_touch.kept, 0.85);
  EXPECT_LT(exit.finding.confidence, 0.85 * confidence);
}

TEST(KeptTouch, IsTheOneBeforeIfTheBallRollsOn) {
  ScriptedGame game = in_play();
  game.kick(kYellow1.side, kYellow1.number, {0.2, 1.2});
  game.run(0.3);
  skip_moving(game, 1.05);
  const Decision exit = exit_of(game);
  EXPECT_EQ(exit.finding.event, Event::kThrowIn);
  EXPECT_EQ(exit.last_touch.robot, kYellow1);
  EXPECT_GT(exit.last_touch.kept, 0.9);
  EXPECT_LT(exit.last_touch.kept, 1);
}

TEST(KeptTouch, IsUnknownIfTheBallComesFromElsewhere) {
  ScriptedGame game = yellow_has_the_ball();
  game.skip(1.1);
  game.put_ball({-0.6, 1.2});
  game.ball_mps = Vec2(0, 1.5);
  const Decision exit = exit_of(game);
  EXPECT_EQ(exit.finding.event, Event::kTouchLineUnknown);
  EXPECT_FALSE(exit.last_touch.side);
}

TEST(KeptTouch, IsUnknownIfTheBallHasTurnedMeanwhile) {
  ScriptedGame game = in_play();
  game.kick(kYellow1.side, kYellow1.number, {0.2, 1.2});
  game.run(0.3);
  game.skip(1.1);
  game.frame.ball->position_m += Vec2(0.8, 0.6);
  game.ball_mps = Vec2(0.9, 0.7);
  EXPECT_EQ(exit_of(game).finding.event, Event::kTouchLineUnknown);
}

TEST(KeptTouch, IsUnknownIfAnOpponentWasNear) {
  ScriptedGame game = yellow_has_the_ball();
  game.robot(Side::kEast, 3).position_m = game.frame.ball->position_m + Vec2(-0.25, 0.2);
  game.run(0.1);
  game.ball_mps = Vec2(0.2, 1.5);
  skip_moving(game, 1.1);
  EXPECT_FALSE(exit_of(game).last_touch.side);
}

TEST(KeptTouch, IsForgottenAfterSeveralSeconds) {
  ScriptedGame game = yellow_has_the_ball();
  game.ball_mps = Vec2(0.02, 0.15);  // too slow to have been kicked there
  skip_moving(game, 8);
  game.ball_mps = Vec2(0.2, 1.5);
  const Decision exit = exit_of(game);
  ASSERT_TRUE(exit.last_touch.side);
  EXPECT_GE(exit.last_touch.kept, 0.5);
  EXPECT_LE(exit.last_touch.kept, 0.51);
}

TEST(KeptTouch, IsLessSureAfterEachOfTwoGaps) {
  ScriptedGame game = yellow_has_the_ball();
  game.ball_mps = Vec2(0.05, 0.55);
  skip_moving(game, 1.1);
  game.run(0.2);
  skip_moving(game, 1.1);
  const Decision exit = exit_of(game);
  EXPECT_EQ(exit.last_touch.robot, kYellow1);
  EXPECT_GT(exit.last_touch.kept, 0.7);
  EXPECT_LT(exit.last_touch.kept, 0.77);
}

TEST(KeptTouch, GivesWayToTheNextTouch) {
  ScriptedGame game = yellow_has_the_ball();
  game.ball_mps = Vec2(0.1, 0.7);
  skip_moving(game, 1.1);
  game.run(0.2);
  const Vec2 along = game.ball_mps.normalized();
  RobotObservation& robot = game.robot(Side::kEast, 3);
  robot.heading = -along;
  robot.position_m =
      game.frame.ball->position_m + along * (kFrontDistance_m + kBallRadius_m + 0.001);
  game.ball_mps = -2 * along;  // it bounces off
  const Decision exit = exit_of(game);
  EXPECT_EQ(exit.last_touch.side, Side::kEast);
  EXPECT_EQ(exit.last_touch.kept, 1);
}

// The robots are seen, so nothing begins afresh, and hindsight may be sure.
TEST(KeptTouch, IsAlsoKnownIfOnlyTheBallIsUnseen) {
  for (const double gap_s : {0.3, 0.7, 1.5}) {
    ScriptedGame game = yellow_has_the_ball();
    const BallObservation before = *game.frame.ball;
    game.frame.ball.reset();
    game.run(gap_s);
    game.frame.ball = before;
    game.ball_mps = Vec2(0.2, 1.0);
    game.frame.ball->position_m += game.ball_mps * gap_s;
    const Decision exit = exit_of(game);
    EXPECT_EQ(exit.last_touch.robot, kYellow1) << gap_s;
  }
}

}  // namespace
}  // namespace autoref::referee
