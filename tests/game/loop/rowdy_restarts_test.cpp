// The fouls of `rowdy` at restarts and in stops really happen in the simulated world.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "strategies/rowdy/foul_behaviours.hpp"
#include "tests/game/loop/foul_behaviour.hpp"

namespace autoref::game {
namespace {

// Counts the kicker's touches that begin after the ball has moved 50 mm, until another robot's
// touch.
TEST(Rowdy, TouchesTheBallTwiceAtARestart) {
  for (const CommandKind kind : {CommandKind::kDirectFree, CommandKind::kIndirectFree}) {
    FoulBehaviour game("second_touch");
    const Vec2 from_m(-0.5, 1);
    game.put_ball(from_m);
    game.restart(kind, Side::kWest);
    ASSERT_TRUE(game.happens(12, [&] { return !game.world.touches().empty(); }));
    const RobotId kicker = game.world.touches()[0].robot;
    ASSERT_TRUE(game.happens(3, [&] { return game.to_ball_m(kicker) > 20_mm; }));
    EXPECT_TRUE(game.happens(5, [&] { return !game.world.touches().empty(); }));
    EXPECT_EQ(game.world.touches()[0].robot, kicker);
    EXPECT_GT((game.ball().position_m - from_m).norm(), 50_mm);
  }
}

TEST(Rowdy, StandsTooCloseAtTheOpponentsRestarts) {
  FoulBehaviour game("crowd_restart");
  game.put_ball({0.5, 1});
  game.restart(CommandKind::kDirectFree, Side::kEast);
  game.run(5);
  EXPECT_LT(game.nearest_to_ball_m(), 0.4);
  EXPECT_GT(game.nearest_to_ball_m(), 0.1);
}

TEST(Rowdy, StandsNearTheBallWhilePlayIsStopped) {
  FoulBehaviour game("stop_crowd");
  game.put_ball({0.5, 1});
  ASSERT_TRUE(game.happens(4, [&] { return game.nearest_to_ball_m() < 0.4; }));
  game.run(2);
  EXPECT_LT(game.nearest_to_ball_m(), 0.4);
}

TEST(Rowdy, DrivesFastWhilePlayIsStopped) {
  FoulBehaviour game("stop_sprint");
  game.put_ball({1, 0});
  game.run(2.5);
  int fast_frames = 0;
  game.happens(3, [&] {
    const double first_mps = game.robot(kFirst).velocity_mps.norm();
    const double second_mps = game.robot(kSecond).velocity_mps.norm();
    fast_frames += std::max(first_mps, second_mps) > 1.6 ? 1 : 0;
    return false;
  });
  EXPECT_GT(fast_frames, 12);  // 0.2 s
}

TEST(Rowdy, WaitsNearTheOpponentsAreaAtARestart) {
  FoulBehaviour game("near_area");
  game.put_robot(kFirst, {1.2, 0.4});
  game.put_ball({1, 1.9});
  game.run(5);
  game.restart(CommandKind::kDirectFree, Side::kEast);
  game.run(2);
  const double to_hull_m =
      std::min(game.to_area_m(Side::kEast, kFirst), game.to_area_m(Side::kEast, kSecond)) -
      kRobotRadius_m;
  EXPECT_LT(to_hull_m, 0.15);
  EXPECT_GT(to_hull_m, 0);
}

// A free kick against the side may be taken from the position of the offending robot.
TEST(Rowdy, MakesRoomForABallPlacedWhereItWaits) {
  FoulBehaviour game("near_area");
  game.put_robot(kFirst, {1.2, 0.4});
  game.put_ball({1, 1.9});
  game.run(5);
  const Vec2 position_m = game.robot(kFirst).position_m;
  game.signal.placement = Placement{position_m, false};
  game.run(5);
  EXPECT_GT((game.robot(kFirst).position_m - position_m).norm(), 0.5);
}

TEST(Rowdy, LetsItsRestartRunOut) {
  FoulBehaviour game("delay");
  game.put_ball({0.5, 1});
  game.restart(CommandKind::kDirectFree, Side::kWest);
  EXPECT_FALSE(game.happens(11, [&] { return !game.world.touches().empty(); }));
}

TEST(Rowdy, HasARobotInTheOpponentsHalfAtAKickoff) {
  for (const Side kicks_off : kSides) {
    FoulBehaviour game("kickoff_intruder");
    game.command(CommandKind::kPrepareKickoff, kicks_off);
    game.run(5);
    game.command(CommandKind::kNormalStart);
    game.run(0.2);
    const double front_x =
        std::max(game.robot(kFirst).position_m.x(), game.robot(kSecond).position_m.x());
    EXPECT_GT(front_x, kRobotRadius_m);
  }
}

TEST(Rowdy, SendsItsKeeperOffTheLineAtAPenalty) {
  FoulBehaviour game("keeper_off_line");
  game.put_ball(game.field.penalty_mark_at(Side::kWest));
  game.command(CommandKind::kPreparePenalty, Side::kEast);
  game.run(5);
  game.command(CommandKind::kNormalStart);
  game.run(1);
  EXPECT_GT(game.robot(kKeeper).position_m.x(), -game.field.half_length_m() + 0.2);
}

TEST(Rowdy, HasARobotBesideTheMarkAtPenalties) {
  for (const Side kicks : kSides) {
    FoulBehaviour game("penalty_crowd");
    const Vec2 mark_m = game.field.penalty_mark_at(opponent_of(kicks));
    game.put_ball(mark_m);
    game.command(CommandKind::kPreparePenalty, kicks);
    game.run(7);
    const auto is_beside = [&](RobotId id) {
      return std::abs(game.robot(id).position_m.x() - mark_m.x()) < 0.2 &&
             std::abs(game.robot(id).position_m.y() - mark_m.y()) > 0.3;
    };
    EXPECT_TRUE(is_beside(kFirst) || is_beside(kSecond)) << name_of(kicks);
  }
}

TEST(Rowdy, RequestsATimeoutOnlyInAStop) {
  FoulBehaviour game("timeout");
  EXPECT_TRUE(game.happens(1, [&] { return game.teams[Side::kWest]->requests().timeout; }));
  game.start();
  EXPECT_FALSE(game.happens(3, [&] { return game.teams[Side::kWest]->requests().timeout; }));
}

TEST(Rowdy, StandsStillInHalt) {
  for (const strategies::rowdy::FoulBehaviour* kind : strategies::rowdy::all_kinds()) {
    FoulBehaviour game{std::string(kind->name)};
    game.run(0.5);
    game.command(CommandKind::kHalt);
    game.frame();
    game.frame();
    for (const RobotCommand& command : game.commands[Side::kWest]) {
      ASSERT_EQ(command.velocity_mps, Vec2(0, 0)) << kind->name;
    }
  }
}

}  // namespace
}  // namespace autoref::game
