#include <gtest/gtest.h>
#include "referee/rules/rule.hpp"

#include "soccer/random.hpp"
#include "tests/referee/rules/rule_scene.hpp"

namespace autoref::referee {
namespace {

ScriptedGame shot(const Configuration& configuration, const Vec2& velocity_mps) {
  ScriptedGame game = in_play(configuration);
  game.carpet_mps2 = 3.4;
  game.kick_from(Side::kWest, 1, {-1, 1.2}, velocity_mps);
  return game;
}

TEST(KickSpeed, OfMoreThan8MetresPerSecondGivesAnIndirectFreeKick) {
  ScriptedGame game = shot(by_book("2014"), {8.1, 0});
  const Decision call = game.run_until("bot_kicked_ball_too_fast", 0.2);
  EXPECT_NEAR(call.finding.value, 8.1, 0.03);
  EXPECT_EQ(call.finding.threshold, 8);
  EXPECT_EQ(call.finding.offender, Side::kWest);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
  EXPECT_LE((*call.finding.position_m - Vec2(-1, 1.2)).norm(), 1e-6);
  EXPECT_EQ(call.finding.details.is_chipped, false);
}

TEST(KickSpeed, SlightlyBelowTheLimitIsAllowed) {
  ScriptedGame game = shot(by_book("2014"), {7.9, 0});
  EXPECT_FALSE(is_called(game, "bot_kicked_ball_too_fast"));
}

// The carpet slows the ball by 0.06 m/s per frame.
class KickSpeedOn : public testing::TestWithParam<double> {};  // carpet, in m/s^2

bool is_kick_called(double speed_mps, double carpet_mps2) {
  ScriptedGame game = in_play(by_book("2014"));
  game.carpet_mps2 = carpet_mps2;
  game.kick_from(Side::kWest, 1, {-1, 1.2}, {speed_mps, 0});
  return is_called(game, "bot_kicked_ball_too_fast", 0.3);
}

TEST_P(KickSpeedOn, IsMeasuredAtTheKickItself) {
  EXPECT_FALSE(is_kick_called(7.95, GetParam()));
  EXPECT_TRUE(is_kick_called(8.05, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Carpets, KickSpeedOn, testing::Values(3.0, 3.9),
                         [](const auto& test) { return test.param < 3.5 ? "Smooth" : "Rough"; });

bool is_kick_called_before_touch(double speed_mps) {
  ScriptedGame game = shot(by_book("2014"), {speed_mps, 0});
  game.run(0.1);
  RobotObservation& east = game.robot(Side::kEast, 1);
  east.heading = Vec2(-1, 0);
  east.position_m = game.frame.ball->position_m + Vec2(kFrontDistance_m + kBallRadius_m + 0.001, 0);
  game.ball_mps = {-2, 0};
  return is_called(game, "bot_kicked_ball_too_fast", 0.3);
}

TEST(KickSpeed, IsMeasuredEvenIfTheBallIsSoonTouchedAgain) {
  EXPECT_FALSE(is_kick_called_before_touch(7.9));
  EXPECT_TRUE(is_kick_called_before_touch(8.1));
}

TEST(KickSpeed, IsLimitedTo6AndAHalfMetresPerSecondIn2026) {
  ScriptedGame slow = shot(by_book("2026-b"), {6.4, 0});
  EXPECT_FALSE(is_called(slow, "bot_kicked_ball_too_fast"));
  ScriptedGame fast = shot(by_book("2026-b"), {6.6, 0});
  const Decision call = fast.run_until("bot_kicked_ball_too_fast");
  EXPECT_EQ(call.to, State::kRun);
  EXPECT_TRUE(call.finding.is_foul);
  fast.run(1);
  EXPECT_EQ(fast.count("bot_kicked_ball_too_fast"), 1);
}

// The number of calls for a chip with 5 m/s along the carpet that rises at that speed.
int calls_of_chip(double rise_mps) {
  ScriptedGame game = shot(by_book("2026-b"), {5, 0});
  for (int i = 0; i < 12; ++i) {
    const double t_s = i / ScriptedGame::kRate_hz;
    game.frame.ball->height_m = t_s * (rise_mps - kGravity_mps2 / 2 * t_s);
    game.step();
  }
  return game.count("bot_kicked_ball_too_fast");
}

TEST(KickSpeed, IncludesAChipsVerticalSpeedIn2026) {
  EXPECT_EQ(calls_of_chip(4.0), 0);  // 6.40 m/s
  EXPECT_EQ(calls_of_chip(4.3), 1);  // 6.59 m/s
}

TEST(KickSpeed, IsNotCalledIfNobodyKicked) {
  ScriptedGame game = in_play(by_book("2014"));
  game.put_ball({0, 1.2});
  game.run(0.1);
  game.ball_mps = {9, 0};
  EXPECT_FALSE(is_called(game, "bot_kicked_ball_too_fast"));
}

TEST(KickSpeed, IsNotBlamedOnARobotThatTheBallGlancesOff) {
  ScriptedGame game = in_play(by_book("2014"));
  game.carpet_mps2 = 3.4;
  game.put_ball({-1.9, 1.5});
  game.run(0.1);
  game.ball_mps = {9.2, 0};  // kicked by an unknown robot
  game.run(0.2);
  RobotObservation& east = game.robot(Side::kEast, 1);
  east.heading = Vec2(-1, 0);
  east.position_m = game.frame.ball->position_m + Vec2(kFrontDistance_m + kBallRadius_m + 0.001, 0);
  game.ball_mps = {-8.2, 0};
  EXPECT_FALSE(is_called(game, "bot_kicked_ball_too_fast"));
}

// If the height is unknown, the call waits until a chip can be ruled out.
TEST(KickSpeed, IsAlsoCalledWithoutHeights) {
  ScriptedGame game = in_play(by_book("2014"));
  game.frame.ball->height_m.reset();
  game.kick_from(Side::kWest, 1, {-1, 1.2}, {8.6, 0});
  EXPECT_TRUE(is_called(game, "bot_kicked_ball_too_fast", 0.4));
}

TEST(KickSpeed, IsNotCalledBecauseOfNoise) {
  Configuration configuration = without(by_book("2014"), RuleId::kAttackerDoubleTouchedBall);
  configuration.noise.ball_m = 0.0014;
  ScriptedGame game = in_play(configuration);
  game.carpet_mps2 = 3.4;
  RandomStream random(11);
  for (int kick = 0; kick < 50; ++kick) {
    game.kick_from(Side::kWest, 1, {-2, 1.2}, {7.9, 0});
    Vec2 true_m = game.frame.ball->position_m;
    for (int i = 0; i < 30; ++i) {
      const double x_m = random.normal();
      const double y_m = random.normal();
      game.frame.ball->position_m = true_m + 0.0014 * Vec2(x_m, y_m);
      game.step();
      true_m += game.ball_mps / ScriptedGame::kRate_hz;
    }
  }
  EXPECT_EQ(game.count("bot_kicked_ball_too_fast"), 0);
}

TEST(KickSpeed, IsAllowedIfTheRuleIsNotInForce) {
  ScriptedGame game = shot(without(by_book("2014"), RuleId::kBotKickedBallTooFast), {9, 0});
  EXPECT_FALSE(is_called(game, "bot_kicked_ball_too_fast"));
}

}  // namespace
}  // namespace autoref::referee
