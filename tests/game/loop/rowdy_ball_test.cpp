// The ball fouls of `rowdy` really happen in the simulated world.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/game/loop/foul_behaviour.hpp"

namespace autoref::game {
namespace {

TEST(Rowdy, KicksHarderThanBasicEverDoes) {
  FoulBehaviour game("hard_kick");
  game.put_robot(kFirst, {0.5, 0});
  game.put_ball({1, 0});
  game.start();
  EXPECT_TRUE(game.happens(5, [&] { return game.ball_mps() > 7.4; }));
}

TEST(Rowdy, ChipsIntoTheGoal) {
  FoulBehaviour game("chip_goal");
  game.put_robot(kFirst, {1.2, 0});
  game.put_ball({1.5, 0});
  game.start();
  double highest_m = 0;
  EXPECT_TRUE(game.happens(5, [&] {
    highest_m = std::max(highest_m, game.ball().height_m);
    return game.ball().position_m.x() > game.field.half_length_m() + kBallRadius_m;
  }));
  EXPECT_GT(highest_m, 0.15);
  EXPECT_LT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
}

TEST(Rowdy, ShootsStraightAtTheGoalFromAnIndirectFreeKick) {
  FoulBehaviour game("indirect_shot");
  game.put_robot(kSecond, {2.0, -0.9});  // a pass option for `basic`
  game.put_ball({0.8, 1.2});
  game.restart(CommandKind::kIndirectFree, Side::kWest);
  EXPECT_TRUE(game.happens(
      10, [&] { return game.ball().position_m.x() > game.field.half_length_m() + kBallRadius_m; }));
  EXPECT_LT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
}

TEST(Rowdy, PlaysAFreeKickIntoItsOwnGoal) {
  FoulBehaviour game("own_goal_kick");
  game.put_ball({-1.5, 0.8});
  game.restart(CommandKind::kDirectFree, Side::kWest);
  bool others_touched = false;
  EXPECT_TRUE(game.happens(12, [&] {
    others_touched = others_touched || game.touches_ball(kKeeper);
    return game.ball().position_m.x() < -game.field.half_length_m() - kBallRadius_m;
  }));
  EXPECT_LT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
  EXPECT_FALSE(others_touched);
}

TEST(Rowdy, PlaysTheBallWithAFieldPlayerInItsOwnArea) {
  FoulBehaviour game("play_in_own_area");
  game.put_ball({-2.6, 0.2});
  game.start();
  EXPECT_TRUE(game.happens(6, [&] {
    return game.touches_ball(kFirst) && game.to_area_m(Side::kWest, kFirst) < -kRobotRadius_m;
  }));
}

TEST(Rowdy, TouchesTheBallWithAFieldPlayerPartlyInItsOwnArea) {
  for (const double inside_m : {0.10, 0.05, -0.04, -0.07}) {
    FoulBehaviour game("play_at_own_area");
    game.put_ball({-game.field.half_length_m() + game.field.defence_area.depth_m - inside_m, 0.1});
    game.start();
    ASSERT_TRUE(game.happens(6, [&] { return game.touches_ball(kFirst); })) << inside_m;
    EXPECT_LT(game.to_area_m(Side::kWest, kFirst), kRobotRadius_m) << inside_m;
    EXPECT_GT(game.to_area_m(Side::kWest, kFirst), -kRobotRadius_m) << inside_m;
  }
}

TEST(Rowdy, PlaysTheBallInTheOpponentsArea) {
  FoulBehaviour game("attack_in_area");
  game.put_robot(kFirst, {1.6, 0.5});
  game.put_ball({2.5, 0.2});
  game.start();
  EXPECT_TRUE(game.happens(6, [&] {
    return game.touches_ball(kFirst) && game.to_area_m(Side::kEast, kFirst) < kRobotRadius_m;
  }));
}

// Distance that the west's first robot dribbles the ball before losing it.
double dribbled_m(std::uint64_t seed) {
  FoulBehaviour game("long_dribble", {"dummy", 2, {}}, seed);
  game.put_robot(kFirst, {-1.2, 0});
  game.put_ball({-1.2 + kFrontDistance_m + kBallRadius_m + 2_mm, 0});
  game.start();
  const Vec2 from_m = game.ball().position_m;
  game.happens(6, [&] { return game.to_ball_m(kFirst) > 20_mm; });
  return (game.ball().position_m - from_m).norm();
}

TEST(Rowdy, DribblesTheBallNearAndFar) {
  const Spread dribbled = spread_of(dribbled_m);
  EXPECT_GT(dribbled.least, 0.25);
  EXPECT_LT(dribbled.least, 0.6);
  EXPECT_GT(dribbled.most, 1.2);
  EXPECT_LT(dribbled.most, 1.8);
}

// The longest time that the ball stays with the keeper inside its area.
double held_s(std::uint64_t seed) {
  FoulBehaviour game("keeper_hold", {"dummy", 2, {}}, seed);
  game.put_ball({-2.6, 0.1});
  game.start();
  int now = 0;
  int longest = 0;
  game.happens(25, [&] {
    const bool is_inside =
        distance_to_defence_area(game.field, Side::kWest, game.ball().position_m) < 0;
    now = is_inside && game.to_ball_m(kKeeper) < 20_mm ? now + 1 : 0;
    longest = std::max(longest, now);
    return false;
  });
  return longest / StagedGame::kRate_hz;
}

TEST(Rowdy, LetsItsKeeperHoldTheBall) {
  const Spread held = spread_of(held_s);
  EXPECT_GT(held.least, 2);
  EXPECT_LT(held.least, 8);
  EXPECT_GT(held.most, 15);
}

TEST(Rowdy, ShootsAimlesslyOverTheOpponentsGoalLine) {
  FoulBehaviour game("aimless_kick");
  game.put_ball({-0.7, 0.4});
  game.start();
  ASSERT_TRUE(game.happens(
      12, [&] { return game.ball().position_m.x() > game.field.half_length_m() + kBallRadius_m; }));
  EXPECT_GT(std::abs(game.ball().position_m.y()), game.field.half_goal_m());
}

}  // namespace
}  // namespace autoref::game
