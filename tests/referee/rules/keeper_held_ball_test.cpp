// The keeper may hold the ball for 15 s (Laws 12). The ball may stay in an area for 10 s, in
// Division A for 5 s (2026).
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/referee/rules/driven_game.hpp"

namespace autoref::referee {
namespace {

constexpr RobotId kKeeper{Side::kWest, 0};  // number 0 is the default
constexpr RobotId kOther{Side::kWest, 1};

// A west robot, defending the left goal, has the ball at that distance from its goal line
// and drives back and forth along it. In the end it drives away and leaves the ball.
DrivenGame hold(const char* book, RobotId robot, double seconds, double from_line_m = 0.4) {
  const Configuration configuration = by_book(book);
  DrivenGame game(configuration);
  const double ball_x_m = -configuration.field.half_length_m() + from_line_m;
  game.put(robot, {ball_x_m - kFrontDistance_m - kBallRadius_m, -0.2}, {0, 0});
  game.carry(robot);
  double speed_mps = 0.4;
  for (double left_s = seconds; left_s > 1e-9; left_s -= 1) {
    game.drive(robot, {0, speed_mps});
    game.run(std::min(left_s, 1.0));
    speed_mps = -speed_mps;
  }
  return game;
}

TEST(KeeperHolding, IsCalledAfterFifteenSecondsByTheLaws) {
  EXPECT_TRUE(hold("2014", kKeeper, 14.8).calls(Event::kKeeperHeldBall).empty());
  const DrivenGame game = hold("2014", kKeeper, 15.2);
  ASSERT_EQ(game.calls(Event::kKeeperHeldBall).size(), 1U);
  const Decision call = game.calls(Event::kKeeperHeldBall).front();
  EXPECT_EQ(call.finding.offender, Side::kWest);
  EXPECT_EQ(call.finding.robots.front(), kKeeper);
  EXPECT_NEAR(call.finding.value, 15.0, 0.02);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
}

TEST(KeeperHolding, RestartsOnceTheKeeperReleasesTheBall) {
  DrivenGame game = hold("2014", kKeeper, 10);
  game.carry(kKeeper, 0.03);
  game.run(0.1);
  game.carry(kKeeper);
  game.run(9);
  EXPECT_TRUE(game.calls(Event::kKeeperHeldBall).empty());
}

TEST(KeeperHolding, ConcernsOnlyTheKeeperInsideItsAreaByTheLaws) {
  EXPECT_TRUE(hold("2014", kOther, 16).calls(Event::kKeeperHeldBall).empty());
  EXPECT_TRUE(hold("2014", kKeeper, 16, 1.0).calls(Event::kKeeperHeldBall).empty());
}

TEST(KeeperHolding, IsLimitedToTenSecondsInDivisionBAndFiveInDivisionA) {
  EXPECT_TRUE(hold("2026-b", kKeeper, 9.8).calls(Event::kKeeperHeldBall).empty());
  EXPECT_EQ(hold("2026-b", kKeeper, 10.2).calls(Event::kKeeperHeldBall).size(), 1U);
  EXPECT_TRUE(hold("2026-a", kKeeper, 4.8).calls(Event::kKeeperHeldBall).empty());
  EXPECT_EQ(hold("2026-a", kKeeper, 5.2).calls(Event::kKeeperHeldBall).size(), 1U);
}

TEST(KeeperHolding, In2026ItIsEnoughThatTheBallStaysInsideTheArea) {
  DrivenGame game = hold("2026-b", kKeeper, 2);
  game.carry(std::nullopt);
  game.drive(kKeeper, {-0.5, 0});
  game.run(0.5);
  game.drive(kKeeper, {0, 0});
  game.run(7.8);
  ASSERT_EQ(game.calls(Event::kKeeperHeldBall).size(), 1U);
  EXPECT_EQ(game.calls(Event::kKeeperHeldBall).front().restart(),
            (Command{CommandKind::kDirectFree, Side::kEast}));
}

TEST(KeeperHolding, IsNotAFoulInThePaper) {
  EXPECT_TRUE(hold("paper", kKeeper, 16).calls(Event::kKeeperHeldBall).empty());
}

}  // namespace
}  // namespace autoref::referee
