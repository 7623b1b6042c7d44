#include "live/simulator/robot_updates.hpp"

#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "soccer/units.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::live {
namespace {

class WorldChanges : public testing::Test {
 protected:
  // Applies a teleport that was sent when blue was at this end.
  void teleport(const league::Teleport& teleport, bool blue_on_positive_half = true) {
    const auto change = change_of(teleport, game_.world().state(), game_.configuration().field,
                                  blue_on_positive_half);
    if (change) game::apply(*change, game_);
  }
  const sim::BallState& ball() const { return game_.world().state().ball; }
  const sim::RobotState& robot(Side side, std::size_t index) const {
    return game_.world().state().robots[side].at(index);
  }

  game::Game game_{short_game(10, 1)};
};

TEST_F(WorldChanges, WhatIsNotSetStays) {
  league::BallTeleport teleport_ball;
  teleport_ball.x_m = 1;
  teleport(teleport_ball);
  teleport_ball = {};
  teleport_ball.y_m = -0.5;
  teleport_ball.vx_mps = 2;
  teleport(teleport_ball);
  EXPECT_EQ(ball().position_m, Vec2(1, -0.5));
  EXPECT_EQ(ball().velocity_mps, Vec2(2, 0));
}

TEST_F(WorldChanges, AreTurnedWhenBlueIsOnTheNegativeHalf) {
  league::RobotTeleport teleport_robot;
  teleport_robot.robot = {Side::kEast, 0};
  teleport_robot.x_m = 1;
  teleport_robot.y_m = 0.5;
  teleport_robot.heading_rad = 0;
  teleport(teleport_robot, false);
  EXPECT_EQ(robot(Side::kEast, 0).position_m, Vec2(-1, -0.5));
  EXPECT_NEAR(robot(Side::kEast, 0).heading.x(), -1, 1e-6);
}

TEST_F(WorldChanges, StayInsideTheWalls) {
  league::BallTeleport far_away;
  far_away.x_m = 50;
  teleport(far_away);
  const Field& field = game_.configuration().field;
  EXPECT_LT(ball().position_m.x(), field.length_m / 2 + field.run_off_m);
}

TEST_F(WorldChanges, TakeRobotsOffTheFieldAndPutThemBack) {
  league::RobotTeleport away;
  away.robot = {Side::kWest, 2};
  away.is_present = false;
  teleport(away);
  EXPECT_FALSE(game_.world().is_on(away.robot));
  league::RobotTeleport back;
  back.robot = away.robot;
  back.is_present = true;
  teleport(back);
  EXPECT_FALSE(game_.world().is_on(away.robot)) << "nobody said where";
  back.x_m = -1;
  back.y_m = 0.7;
  teleport(back);
  EXPECT_TRUE(game_.world().is_on(away.robot));
  EXPECT_EQ(robot(Side::kWest, 2).position_m, Vec2(-1, 0.7));
}

TEST_F(WorldChanges, ARobotReturnsOnlyWhereThereIsRoom) {
  league::RobotTeleport away;
  away.robot = {Side::kWest, 2};
  away.is_present = false;
  teleport(away);
  league::RobotTeleport back;
  back.robot = away.robot;
  back.x_m = robot(Side::kWest, 0).position_m.x();
  back.y_m = robot(Side::kWest, 0).position_m.y();
  teleport(back);
  EXPECT_FALSE(game_.world().is_on(away.robot));
}

TEST_F(WorldChanges, TheGameGoesOnAfterThem) {
  league::BallTeleport teleport_ball;
  teleport_ball.x_m = 0.5;
  teleport_ball.vx_mps = 3;
  for (int i = 0; i < 100; ++i) {
    teleport(teleport_ball);
    ASSERT_TRUE(game_.step());
  }
}

}  // namespace
}  // namespace autoref::live
