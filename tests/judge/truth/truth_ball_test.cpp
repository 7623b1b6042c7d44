// True events that concern the ball, in staged worlds.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

// Puts west's robot 1 behind the ball, ready to kick it along `heading`.
void stage_kick(StagedGame& game, const Vec2& from_m, const Vec2& heading) {
  game.world.put_robot(kWest1, from_m, heading);
  game.world.put_ball_at_plate(kWest1);
}

void kick(StagedGame& game, double speed_mps, bool chip = false) {
  game.world.command(kWest1).kick_mps = speed_mps;
  game.world.command(kWest1).chip = chip;
  game.frames(1);
  game.world.command(kWest1).kick_mps = 0;
}

TEST(TrueExit, IsAThrowInByTheLastToucher) {
  StagedGame game;
  stage_kick(game, {0, 1.5}, {0, 1});
  game.command(CommandKind::kForceStart);
  kick(game, 3.0);
  game.seconds(0.5);
  ASSERT_EQ(game.names(), std::vector<std::string>{"throw_in"});
  EXPECT_EQ(game.first("throw_in").offender, Side::kWest);
  EXPECT_NEAR(game.first("throw_in").position_m->y(), 2.025 + 0.0215, 1e-6);
}

TEST(TrueExit, IsACornerKickAfterDefendersAndAGoalKickAfterAttackers) {
  for (const double towards : {-1.0, 1.0}) {
    StagedGame game;
    stage_kick(game, {towards * 2.5, 1.0}, {towards, 0});
    game.command(CommandKind::kForceStart);
    kick(game, 3.0);
    game.seconds(0.5);
    EXPECT_TRUE(game.has(towards < 0 ? "corner_kick" : "goal_kick"));
  }
}

TEST(TrueExit, IsForeseenIfTheRefereeEndsPlayJustBefore) {
  StagedGame game;
  game.world.put_ball({0, 2.025}, {0, 2.0});
  game.command(CommandKind::kForceStart);
  game.signal.placement = Placement{{0, 1.9}, false};
  game.command(CommandKind::kStop);
  // The command is sent in a frame in which play is still on.
  ASSERT_FALSE(game.observer.true_events().empty());
  EXPECT_EQ(game.observer.true_events().back().standing, Standing::kPrevented);
}

TEST(TrueGoal, IsScoredByTheAttackers) {
  StagedGame game;
  stage_kick(game, {2.0, 0}, {1, 0});
  game.command(CommandKind::kForceStart);
  kick(game, 4.0);
  game.seconds(0.6);
  ASSERT_EQ(game.names(), std::vector<std::string>{"goal"});
  EXPECT_EQ(game.first("goal").offender, Side::kWest);
}

TEST(TrueGoal, DoesNotCountAfterAChipThatHasNotRolled) {
  for (const char* rules : {"paper", "2014"}) {
    StagedGame game(book(rules));
    stage_kick(game, {0.25, 0}, {1, 0});  // flies 2.1 m, then makes low hops
    game.command(CommandKind::kForceStart);
    kick(game, 4.5, true);
    game.seconds(1.5);
    EXPECT_TRUE(game.has(book(rules).has(RuleId::kChippedGoal) ? "chipped_goal" : "goal")) << rules;
  }
}

TEST(TrueGoal, DoesNotCountStraightFromAnIndirectFreeKick) {
  StagedGame game;
  stage_kick(game, {2.0, 0}, {1, 0});
  game.command(CommandKind::kIndirectFree, Side::kWest);
  kick(game, 4.0);
  game.seconds(0.6);
  EXPECT_TRUE(game.has("indirect_goal"));
}

TEST(TrueGoal, DirectlyIntoTheOwnGoalIsACorner) {
  StagedGame game;
  stage_kick(game, {-2.0, 0}, {-1, 0});
  game.command(CommandKind::kDirectFree, Side::kWest);
  kick(game, 4.0);
  game.seconds(0.6);
  EXPECT_TRUE(game.has("free_kick_own_goal"));
  EXPECT_EQ(game.first("free_kick_own_goal").offender, Side::kWest);
}

TEST(TrueKick, IsTooFastOnlyAboveTheLimit) {
  RuleBook rules = book("2014");
  rules.kick_limit_mps = 4.0;
  for (const double speed_mps : {3.0, 5.0}) {
    StagedGame game(rules);
    stage_kick(game, {0, 0}, {1, 0});
    game.command(CommandKind::kForceStart);
    kick(game, speed_mps);
    EXPECT_EQ(game.has("bot_kicked_ball_too_fast"), speed_mps > 4.0);
  }
}

TEST(TrueKick, IsMeasuredInThreeDimensionsByTheRulesOf2026) {
  RuleBook rules = book("2026-b");
  rules.kick_limit_mps = 4.0;
  StagedGame game(rules);
  stage_kick(game, {0, 0}, {1, 0});
  game.command(CommandKind::kForceStart);
  kick(game, 5.0, true);  // 3.5 m/s horizontally and vertically
  EXPECT_TRUE(game.has("bot_kicked_ball_too_fast"));
}

TEST(TrueDoubleTouch, IsTheKickersSecondTouchBeforeAnotherRobots) {
  StagedGame game;
  stage_kick(game, {0, 0}, {1, 0});
  game.command(CommandKind::kDirectFree, Side::kWest);
  kick(game, 2.0);
  game.frames(10);
  EXPECT_FALSE(game.has("attacker_double_touched_ball"));
  game.world.put_ball({0.2, 0}, {-2.0, 0});
  game.frames(6);
  ASSERT_TRUE(game.has("attacker_double_touched_ball"));
  EXPECT_EQ(game.first("attacker_double_touched_ball").robot, kWest1);
}

TEST(TrueDribbling, IsTooLongAfterFiftyCentimetres) {
  StagedGame game;
  stage_kick(game, {-1, 0}, {1, 0});
  game.command(CommandKind::kForceStart);
  game.world.command(kWest1) = {{1.0, 0}, 0, 0, false, true};
  game.seconds(0.4);
  EXPECT_FALSE(game.has("bot_dribbled_ball_too_far"));
  game.seconds(1.0);
  ASSERT_TRUE(game.has("bot_dribbled_ball_too_far"));
  EXPECT_EQ(game.first("bot_dribbled_ball_too_far").robot, kWest1);
}

TEST(TrueDribbling, IsNearTheLimitOnlyIfItEndsThere) {
  for (const double path_m : {0.53, 0.6}) {
    StagedGame game;
    stage_kick(game, {-1, 0}, {1, 0});
    const double from_m = game.world.ball().position_m.x();
    game.command(CommandKind::kForceStart);
    game.world.command(kWest1) = {{1.0, 0}, 0, 0, false, true};
    while (game.world.ball().position_m.x() - from_m < path_m) game.frames(1);
    ASSERT_EQ(game.times_s("bot_dribbled_ball_too_far").size(), 1U);
    EXPECT_EQ(game.first("bot_dribbled_ball_too_far").is_borderline, path_m < 0.55) << path_m;
  }
}

TEST(TrueDribbling, IsForeseenIfTheRefereeEndsPlayJustBefore) {
  for (const double short_of_m : {0.03, 0.2}) {
    StagedGame game;
    stage_kick(game, {-1, 0}, {1, 0});
    game.command(CommandKind::kForceStart);
    game.world.command(kWest1) = {{1.0, 0}, 0, 0, false, true};
    const double from_m = game.world.world.state().ball.position_m.x();
    while (game.world.world.state().ball.position_m.x() - from_m < 0.5 - short_of_m) game.frames(1);
    game.command(CommandKind::kStop);
    const auto& all = game.observer.true_events();
    EXPECT_EQ(std::any_of(all.begin(), all.end(),
                          [](const TrueEvent& event) {
                            return event.name == "bot_dribbled_ball_too_far" &&
                                   event.standing == Standing::kPrevented;
                          }),
              short_of_m < 0.1);
  }
}

TEST(TrueHolding, IsCalledAfterFifteenSecondsInTheKeepersArea) {
  StagedGame game;
  game.world.put_robot(kWest0, {-2.9, 0});
  game.world.put_ball_at_plate(kWest0);
  game.command(CommandKind::kForceStart);
  game.world.command(kWest0).dribble = true;
  game.world.command(kWest0).velocity_mps = {0.005, 0};  // keeps the ball at the plate
  game.seconds(14.0);
  EXPECT_FALSE(game.has("keeper_held_ball"));
  game.seconds(2.0);
  EXPECT_TRUE(game.has("keeper_held_ball"));
}

TEST(TrueStuckBall, IsCalledAfterTenSeconds) {
  StagedGame game;
  game.world.put_ball({0, 0.5});
  game.command(CommandKind::kForceStart);
  game.seconds(9.5);
  EXPECT_FALSE(game.has("stuck_ball"));
  game.seconds(1.0);
  EXPECT_TRUE(game.has("stuck_ball"));
}

// Laws 2014: the keeper has 15 s, so its ball is not stuck after 10 s.
TEST(TrueStuckBall, IsNotAKeepersInItsOwnArea) {
  StagedGame game;
  game.world.put_robot(kWest0, {-2.9, 0});
  game.world.put_ball_at_plate(kWest0);
  game.command(CommandKind::kForceStart);
  game.world.command(kWest0).dribble = true;
  game.world.command(kWest0).velocity_mps = {0.005, 0};  // keeps the ball at the plate
  game.seconds(16.0);
  EXPECT_FALSE(game.has("stuck_ball"));
  EXPECT_TRUE(game.has("keeper_held_ball"));
}

TEST(TrueAimlessKick, LeavesTheFieldUntouchedFromTheOwnHalf) {
  for (const double from_x_m : {-0.5, 0.5}) {
    StagedGame game(book("2026-b"));
    stage_kick(game, {from_x_m, 1.0}, {1, 0});
    game.command(CommandKind::kForceStart);
    kick(game, 6.0);
    game.seconds(1.5);
    EXPECT_TRUE(game.has(from_x_m < 0 ? "aimless_kick" : "goal_kick"));
  }
}

}  // namespace
}  // namespace autoref::judge::ground_truth
