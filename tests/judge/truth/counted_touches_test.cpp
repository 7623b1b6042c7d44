// Which touches of the ball count for exits, kicks and goals, in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

void place_kicker(StagedGame& game, RobotId id, const Vec2& from_m, const Vec2& heading = {1, 0}) {
  game.world.put_robot(id, from_m, heading);
  game.world.put_ball_at_plate(id);
}

void shoot(StagedGame& game, RobotId id, double speed_mps, bool chip = false) {
  game.world.command(id).kick_mps = speed_mps;
  game.world.command(id).chip = chip;
  game.frames(1);
  game.world.command(id).kick_mps = 0;
}

TEST(TrueExit, BelongsToTheTouchBeforeTheBallIsOut) {
  StagedGame game;
  place_kicker(game, kWest1, {0, 1.5}, {0, 1});
  game.command(CommandKind::kForceStart);
  shoot(game, kWest1, 3.0);
  // In one frame, the ball is out at 2.0465 m and then hits an opponent outside.
  game.world.put_robot(kEast1, {0, 2.19}, {0, 1});
  game.world.put_ball({0, 2.03}, {0, 6});
  game.frames(1);
  ASSERT_FALSE(game.world.world.touches().empty());
  ASSERT_TRUE(game.has("throw_in"));
  EXPECT_EQ(game.first("throw_in").offender, Side::kWest);
}

sim::Touch touch_at(RobotId id, int substep, const Vec2& ball_m) {
  sim::Touch touch;
  touch.robot = id;
  touch.substep = substep;
  touch.ball_m = ball_m;
  return touch;
}

// Shows touches at the touch line to the observer, then the ball outside.
struct TouchesAtTheLine : StagedGame {
  TouchesAtTheLine() {
    command(CommandKind::kForceStart);
    world.put_robot(kWest1, {0.5, 1.9}, {1, 0});
    world.put_robot(kEast1, {-0.5, 1.9}, {-1, 0});
    world.put_ball({0, 2.0});
    world.frame();
  }
  void leave(std::vector<sim::Touch> touches) {
    observer.see(world.world.state(), touches, {}, signal);
    world.put_ball({0, 2.06}, {0, 1});
    frames(1);
  }
};

// Contacts of one sub-step have no order.
TEST(TrueExit, IsNobodysIfBothSidesTouchedTheBallAtOnce) {
  for (const int substep : {2, 3}) {
    TouchesAtTheLine game;
    game.leave({touch_at(kWest1, 2, {0, 2}), touch_at(kEast1, substep, {0, 2})});
    ASSERT_TRUE(game.has("throw_in"));
    const std::optional<Side> offender = game.first("throw_in").offender;
    EXPECT_EQ(offender, substep == 2 ? std::nullopt : std::optional(Side::kEast));
  }
}

// The world notes a lasting contact in the first sub-step of a frame.
TEST(TrueExit, BelongsToTheRobotStillAtTheBallAtTheEndOfTheFrame) {
  TouchesAtTheLine game;
  game.world.put_robot(kWest1, Vec2(-kFrontDistance_m - kBallRadius_m, 2.0), {1, 0});
  game.world.put_ball({0, 2.0});
  game.world.frame();
  game.leave({touch_at(kWest1, 0, {0, 2}), touch_at(kEast1, 2, {0, 2.001})});
  ASSERT_TRUE(game.has("throw_in"));
  EXPECT_EQ(game.first("throw_in").offender, Side::kWest);
}

TEST(TrueKick, IsNotExcusedByASlowerKickJustBefore) {
  RuleBook rules = book("2014");
  rules.kick_limit_mps = 4.0;
  StagedGame game(rules);
  place_kicker(game, kWest1, {0, 0});
  game.command(CommandKind::kForceStart);
  shoot(game, kWest1, 3.9);  // a near miss
  game.frames(7);            // the kicker recharges
  game.world.put_ball_at_plate(kWest1);
  shoot(game, kWest1, 5.0);
  EXPECT_TRUE(game.has("bot_kicked_ball_too_fast"));
}

// The ball has been chipped by the west and bounces low, without rolling.
struct BouncingChip : StagedGame {
  explicit BouncingChip(const char* rules) : StagedGame(book(rules)) {
    place_kicker(*this, kWest1, {-1, 0.5});
    command(CommandKind::kForceStart);
    shoot(*this, kWest1, 4.5, true);
    frames(10);
    world.put_robot(kEast1, {1, 0.5}, {-1, 0});
  }
  void hit_defender() {
    world.put_ball({0.85, 0.5}, {2, 0});
    frames(4);
  }
  void score() {
    world.put_ball({2.95, 0}, {4, 0});
    frames(4);
  }
};

// Laws 2014, law 12, decision 7.
TEST(TrueGoal, CountsIfAChipStaysLowAfterTouchingAnOpponent) {
  for (const bool is_deflected : {false, true}) {
    BouncingChip game("2014");
    if (is_deflected) game.hit_defender();
    game.score();
    EXPECT_EQ(game.has("goal"), is_deflected);
    EXPECT_EQ(game.has("chipped_goal"), !is_deflected);
  }
}

// The 2026 rules ask for the last touch of the scorers, whoever touched the ball since.
TEST(Truth2026, AGoalIsInvalidAfterAHighBallEvenIfAnOpponentTouchedItSince) {
  BouncingChip game("2026-b");
  game.hit_defender();
  game.score();
  EXPECT_TRUE(game.has("invalid_goal"));
}

// The east chips into its own goal.
TEST(TrueGoal, CountsAfterAChipIntoTheOwnGoalOnlyByTheLaws) {
  for (const bool has_west_touched : {false, true}) {
    for (const char* rules : {"2014", "2026-b"}) {
      StagedGame game(book(rules));
      place_kicker(game, kWest1, {-1, 0.5});
      game.command(CommandKind::kForceStart);
      if (has_west_touched) shoot(game, kWest1, 1.0);
      place_kicker(game, kEast1, {0.25, 0});
      shoot(game, kEast1, 4.5, true);
      game.seconds(1.5);
      const bool is_laws = book(rules).edition == Edition::kLaws2014;
      EXPECT_EQ(game.has("goal"), is_laws) << rules << has_west_touched;
      EXPECT_EQ(game.has("invalid_goal"), !is_laws) << rules << has_west_touched;
    }
  }
}

TEST(Truth2026, AFoulInTheFrameOfTheGoalInvalidatesIt) {
  for (const double west_mps : {0.2, 2.5}) {
    StagedGame game(book("2026-b"));
    game.command(CommandKind::kForceStart);
    game.world.put_robot(kWest1, {-0.093, 0}, {1, 0}, {west_mps, 0});
    game.world.put_robot(kEast1, {0.093, 0}, {-1, 0});
    game.world.put_ball({3.03, 0}, {4, 0});
    game.frames(1);
    EXPECT_EQ(game.has("invalid_goal"), west_mps > 1.5) << west_mps;
    EXPECT_EQ(game.has("goal"), west_mps < 1.5) << west_mps;
  }
}

}  // namespace
}  // namespace autoref::judge::ground_truth
