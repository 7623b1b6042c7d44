// True double touches, in staged worlds.
#include <gtest/gtest.h>

#include "tests/judge/truth/truth_stage.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr const char* kAgain = "attacker_double_touched_ball";

// Puts the ball in front of the west's robot 1, which faces east; returns the ball's x.
double lay_ball(StagedGame& game, const Vec2& kicker_m) {
  game.world.put_robot(kWest1, kicker_m);
  game.world.put_ball_at_plate(kWest1);
  return game.world.ball().position_m.x();
}

// Robot 1 of the west pushes the ball on until it is this far from where it lay.
void push_restart(StagedGame& game, double from_x_m, double path_m) {
  game.world.command(kWest1) = {{0.3, 0}, 0, 0, false, true};
  while (game.world.ball().position_m.x() - from_x_m < path_m) game.frames(1);
}

// "Under no circumstances should the robot remain in contact or touch the ball after it has
// traveled 50 mm" (Laws, law 9, decision 1); the 2026 rules say the same.
TEST(TrueDoubleTouch, IncludesContactThatLastsBeyondFiftyMillimetres) {
  for (const char* rules : {"2014", "2026-b"}) {
    StagedGame game(book(rules));
    const double from_x_m = lay_ball(game, {0, 0});
    game.command(CommandKind::kDirectFree, Side::kWest);
    push_restart(game, from_x_m, 0.03);
    EXPECT_FALSE(game.has(kAgain)) << rules;
    push_restart(game, from_x_m, 0.051);
    ASSERT_TRUE(game.has(kAgain)) << rules;
    EXPECT_EQ(game.first(kAgain).robot, kWest1);
    EXPECT_TRUE(game.first(kAgain).is_borderline);
    push_restart(game, from_x_m, 0.08);
    EXPECT_FALSE(game.first(kAgain).is_borderline);
    EXPECT_EQ(game.times_s(kAgain).size(), 1U);
  }
}

TEST(TrueDoubleTouch, FollowsTheNumbersOfTheBook) {
  RuleBook rules = book("2026-b");
  rules.double_touch_m = 0.15;
  StagedGame longer(rules);
  const double from_x_m = lay_ball(longer, {0, 0});
  longer.command(CommandKind::kDirectFree, Side::kWest);
  push_restart(longer, from_x_m, 0.14);
  EXPECT_FALSE(longer.has(kAgain));
  push_restart(longer, from_x_m, 0.16);
  EXPECT_TRUE(longer.has(kAgain));

  rules = book("2026-b");
  rules.double_touch_s = 0.5;  // 150 mm at 0.3 m/s
  StagedGame later(rules);
  lay_ball(later, {0, 0});
  later.command(CommandKind::kDirectFree, Side::kWest);
  push_restart(later, from_x_m, 0.15);
  EXPECT_FALSE(later.has(kAgain));
  push_restart(later, from_x_m, 0.3);
  EXPECT_TRUE(later.has(kAgain));
}

// "Following a kick-off or free kick" (2026); at penalty kicks, the attacker may dribble.
TEST(TrueDoubleTouch, IsAllowedAtPenaltyKicksOf2026) {
  for (const char* rules : {"2014", "2026-b"}) {
    StagedGame game(book(rules));
    const double from_x_m = lay_ball(game, {1, 0});
    game.command(CommandKind::kPreparePenalty, Side::kWest);
    game.command(CommandKind::kNormalStart);
    push_restart(game, from_x_m, 0.2);
    EXPECT_EQ(game.has(kAgain), book(rules).edition == Edition::kLaws2014) << rules;
  }
}

TEST(TrueDoubleTouch, IsNotThatOfAnOpponentWhoTouchesFirst) {
  StagedGame game;
  const double from_x_m = lay_ball(game, {0, 0});
  game.command(CommandKind::kDirectFree, Side::kEast);
  push_restart(game, from_x_m, 0.2);
  EXPECT_FALSE(game.has(kAgain));
}

TEST(TrueDoubleTouch, IsOverOnceAnotherRobotHasTouchedTheBall) {
  StagedGame game;
  const double from_x_m = lay_ball(game, {0, 0});
  game.world.put_robot(kEast1, {kFrontDistance_m + 2 * kBallRadius_m + 0.11, 0}, {-1, 0});
  game.command(CommandKind::kDirectFree, Side::kWest);
  game.world.command(kWest1) = {{0.3, 0}, 0, 0, false, true};
  game.seconds(0.5);  // the opponent is in the way after 35 mm
  game.world.put_robot(kEast1, {1.0, -1.9}, {-1, 0});
  push_restart(game, from_x_m, 0.2);
  EXPECT_FALSE(game.has(kAgain));
}

}  // namespace
}  // namespace autoref::judge::ground_truth
