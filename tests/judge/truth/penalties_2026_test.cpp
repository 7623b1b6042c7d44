// Penalty kicks under the 2026 rules ("Penalty Kick") in staged worlds: fouls and positions that
// decide them, and balls that move back.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

// West kicks towards the goal at x = 3.025 from x = 0.25. East's keeper touches its line; the
// others are at x = -1, 1 m or more behind the ball.
struct PenaltyStage : StagedGame {
  explicit PenaltyStage(const RuleBook& rules = book("2026-b")) : StagedGame(rules) {
    world.put_robot(kWest0, {-1.0, 0.8});
    world.put_robot(kEast1, {-1.0, -0.8}, {-1, 0});
    world.put_robot(kEast0, {2.98, 0.25}, {-1, 0});
    world.put_robot(kWest1, {0.25 - kFrontDistance_m - kBallRadius_m, 0}, {1, 0});
    world.put_ball_at_plate(kWest1);
    command(CommandKind::kPreparePenalty, Side::kWest);
  }
  void kick(double speed_mps) {
    command(CommandKind::kNormalStart);
    world.command(kWest1).kick_mps = speed_mps;
    frames(1);
    world.command(kWest1).kick_mps = 0;
  }
};

TEST(TruePenalty2026, ThatGoesInIsAGoal) {
  PenaltyStage game;
  game.kick(4);
  game.seconds(1.5);
  EXPECT_EQ(game.times_s("goal").size(), 1U);
  EXPECT_FALSE(game.has("penalty_kick_failed"));
  EXPECT_FALSE(game.has("penalty_positions"));
}

TEST(TruePenalty2026, IsAGoalIfTheDefendersStandTooNear) {
  PenaltyStage game;
  game.world.put_robot(kEast1, {-0.5, -0.8}, {-1, 0});
  game.kick(0.5);
  game.seconds(0.5);
  EXPECT_EQ(game.first("penalty_positions").offender, Side::kEast);
  EXPECT_EQ(game.first("goal").offender, Side::kWest);  // the scorer
}

TEST(TruePenalty2026, HasFailedIfTheKickersSideStandsTooNear) {
  PenaltyStage game;
  game.world.put_robot(kWest0, {-0.5, 0.8});
  game.kick(0.5);
  game.seconds(0.5);
  EXPECT_EQ(game.first("penalty_positions").offender, Side::kWest);
  EXPECT_EQ(game.first("penalty_kick_failed").offender, Side::kWest);
}

TEST(TruePenalty2026, IsNotDecidedByFaultsOfBothSides) {
  PenaltyStage game;
  game.world.put_robot(kWest0, {-0.5, 0.8});
  game.world.put_robot(kEast1, {-0.5, -0.8}, {-1, 0});
  game.kick(0.5);
  game.seconds(0.5);
  EXPECT_FALSE(game.first("penalty_positions").offender.has_value());
  EXPECT_FALSE(game.has("goal"));
  EXPECT_FALSE(game.has("penalty_kick_failed"));
}

TEST(TruePenalty2026, HasFailedAfterAFoulByTheKicker) {
  RuleBook rules = book("2026-b");
  rules.kick_limit_mps = 4.0;
  PenaltyStage game(rules);
  game.kick(5);
  game.seconds(0.1);
  EXPECT_TRUE(game.has("bot_kicked_ball_too_fast"));
  EXPECT_TRUE(game.has("penalty_kick_failed"));
}

TEST(TruePenalty2026, HasFailedIfTheBallMovesBack) {
  for (const double y_mps : {0.0, 1.0}) {  // sideways is allowed
    PenaltyStage game;
    game.command(CommandKind::kNormalStart);
    game.world.put_robot(kWest1, {-1.0, 1.5});
    game.world.put_ball({0.25, 0}, {y_mps > 0 ? 0.0 : -1.0, y_mps});
    game.seconds(0.4);
    EXPECT_EQ(game.has("penalty_kick_failed"), y_mps == 0);
  }
}

TEST(TruePenalty2026, LetsTheKickerTouchTheBallAgain) {
  PenaltyStage game;
  game.kick(0.5);
  game.frames(20);
  game.world.put_robot(kWest1, game.world.ball().position_m - Vec2(0.3, 0), {1, 0}, {1.5, 0});
  game.world.command(kWest1).velocity_mps = {1.5, 0};
  game.seconds(0.5);
  EXPECT_FALSE(game.has("attacker_double_touched_ball"));
  EXPECT_FALSE(game.has("penalty_kick_failed"));
}

}  // namespace
}  // namespace autoref::judge::ground_truth
