// Non-stopping fouls, the goals they invalidate, and pushing, under the 2026 rules ("Offenses",
// "Scoring Goals"), in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr const char* kKickTooFast = "bot_kicked_ball_too_fast";

// A rule book with a limit that the kicker can exceed on a small field.
RuleBook slow_book() {
  RuleBook rules = book("2026-b");
  rules.kick_limit_mps = 4.0;
  return rules;
}

void put_kicker(StagedGame& game, const Vec2& from_m) {
  game.world.put_robot(kWest1, from_m, {1, 0});
  game.world.put_ball_at_plate(kWest1);
}

void kick_ball(StagedGame& game, double speed_mps, bool chip = false) {
  game.world.command(kWest1).kick_mps = speed_mps;
  game.world.command(kWest1).chip = chip;
  game.frames(1);
  game.world.command(kWest1).kick_mps = 0;
}

// The ball comes back to west's robot 1 at this speed and is kicked again.
void kick_again(StagedGame& game, double ball_mps) {
  const sim::RobotState& kicker = game.world.robot(kWest1);
  game.world.put_ball(kicker.position_m + Vec2(kFrontDistance_m + kBallRadius_m, 0), {ball_mps, 0});
  kick_ball(game, 5.5);
}

TEST(Truth2026, AFastKickIsRaisedAgainOnlyOnceTheBallHasBeenSlower) {
  for (const double between_mps : {4.5, 3.0}) {
    StagedGame game(slow_book());
    put_kicker(game, {-2.0, 0});
    game.command(CommandKind::kForceStart);
    kick_ball(game, 5.0);
    game.frames(15);
    ASSERT_GT(game.world.ball().velocity_mps.x(), 4.0);
    if (between_mps < 4.0) {
      game.world.put_ball({0, 0}, {between_mps, 0});
      game.frames(1);
    }
    kick_again(game, between_mps);
    EXPECT_EQ(game.times_s(kKickTooFast).size(), between_mps < 4.0 ? 2U : 1U) << between_mps;
  }
}

TEST(Truth2026, AnAttackersTouchThatLastsIsRaisedAgainAfterTwoSeconds) {
  StagedGame game(book("2026-b"));
  put_kicker(game, {2.4, 0});
  game.command(CommandKind::kForceStart);
  game.world.command(kWest1) = {{0.005, 0}, 0, 0, false, true};  // keeps the ball at the plate
  game.seconds(4.5);
  const std::vector<double> times_s = game.times_s("attacker_touched_ball_in_defense_area");
  ASSERT_EQ(times_s.size(), 3U);
  EXPECT_NEAR(times_s[1] - times_s[0], 2.0, 0.02);
  EXPECT_NEAR(times_s[2] - times_s[1], 2.0, 0.02);
}

TEST(Truth2026, AGoalByAKickThatIsTooFastIsInvalid) {
  for (const double speed_mps : {3.5, 5.0}) {
    StagedGame game(slow_book());
    put_kicker(game, {1.8, 0});
    game.command(CommandKind::kForceStart);
    kick_ball(game, speed_mps);
    game.seconds(0.6);
    EXPECT_EQ(game.has("invalid_goal"), speed_mps > 4.0) << speed_mps;
    EXPECT_EQ(game.has("goal"), speed_mps < 4.0) << speed_mps;
  }
}

TEST(Truth2026, AGoalAfterATouchInTheOpponentsAreaIsInvalid) {
  StagedGame game(book("2026-b"));
  put_kicker(game, {2.4, 0});
  game.command(CommandKind::kForceStart);
  kick_ball(game, 4.0);
  game.seconds(0.4);
  EXPECT_TRUE(game.has("invalid_goal"));
}

TEST(Truth2026, AGoalWithTooManyRobotsIsInvalid) {
  for (const int allowed : {1, 2}) {
    StagedGame game(book("2026-b"));
    game.signal.robots_allowed[Side::kWest] = allowed;
    put_kicker(game, {1.8, 0});
    game.command(CommandKind::kForceStart);
    kick_ball(game, 4.0);
    game.seconds(0.6);
    EXPECT_EQ(game.has("goal"), allowed == 2) << allowed;
    EXPECT_EQ(game.has("invalid_goal"), allowed == 1) << allowed;
  }
}

TEST(Truth2026, AHighBallFromThePenaltyMarkIsAGoal) {
  StagedGame game(book("2026-b"));
  put_kicker(game, {0.25, 0});
  game.world.put_robot(kEast0, {2.98, 0.25}, {-1, 0});  // the keeper, on its line
  game.world.put_robot(kEast1, {-1.5, -1.9}, {-1, 0});  // 1 m behind the ball
  game.world.put_robot(kWest0, {-2.9, -0.5});
  game.command(CommandKind::kPreparePenalty, Side::kWest);
  game.command(CommandKind::kNormalStart);
  kick_ball(game, 4.5, true);
  game.seconds(1.5);
  EXPECT_FALSE(game.has("invalid_goal"));
  EXPECT_TRUE(game.has("goal"));
}

// Drives robot 1 of both sides eastwards for a second, `apart_m` apart.
void push_east(StagedGame& game, double apart_m, bool with_ball) {
  for (int frame = 0; frame < 60; ++frame) {
    const double x_m = 0.005 * frame;
    game.world.put_robot(kWest1, {x_m, 0});
    game.world.put_robot(kEast1, {x_m + apart_m, 0}, {-1, 0});
    if (with_ball) game.world.put_ball({x_m + kFrontDistance_m + kBallRadius_m, 0}, {0.3, 0});
    game.frames(1);
  }
}

TEST(Truth2026, PushingIncludesPushingThroughTheBall) {
  StagedGame game(book("2026-b"));
  game.command(CommandKind::kForceStart);
  push_east(game, 2 * (kFrontDistance_m + kBallRadius_m), true);
  ASSERT_TRUE(game.has("bot_pushed_bot"));
  EXPECT_EQ(game.first("bot_pushed_bot").robot, kWest1);
}

// A stopping foul should stop play; if the referee misses it, a later goal counts.
TEST(Truth2026, AGoalAfterAStoppingFoulIsNotInvalid) {
  StagedGame game(book("2026-b"));
  game.world.put_ball({0, 1});
  game.command(CommandKind::kForceStart);
  push_east(game, 0.182, false);
  ASSERT_TRUE(game.has("bot_pushed_bot"));
  game.world.put_ball({2.9, 0}, {4.0, 0});
  game.frames(10);
  EXPECT_TRUE(game.has("goal"));
}

}  // namespace
}  // namespace autoref::judge::ground_truth
