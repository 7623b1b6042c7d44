// Robots with different parameters in one world.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr RobotId kWest1{Side::kWest, 1};

// Two robots in the west, the first one modified by `change`.
template <typename Change>
PerSide<TeamSpec> first_changed(Change change) {
  PerSide<TeamSpec> both = specs(2, 0);
  change(both[Side::kWest].robots[0]);
  return both;
}

// Both robots in the west, side by side, facing east; the ball is out of the way.
struct Pair : Scene {
  template <typename Change>
  explicit Pair(Change change) : Scene(quiet(), first_changed(change)) {
    put_robot(kWest0, {-2, 1});
    put_robot(kWest1, {-2, -1});
    put_ball({2, 1.5});
  }
  void command_both(const RobotCommand& both) { command(kWest0) = command(kWest1) = both; }
  void put_ball_before(RobotId id) { put_ball_at_plate(id, 0.005); }
  // Puts the ball before a robot, which may kick it, and waits for twelve frames.
  void play_ball_with(RobotId id) {
    put_ball_before(id);
    frames(12);
  }
  // The speed that the robot's kick gives the ball.
  double kicked_by_mps(RobotId id) {
    put_ball_before(id);
    frame();
    return ball().velocity_mps.x() + 3.4 * 4 / 240;
  }
};

RobotCommand forward(double speed_mps) {
  RobotCommand command;
  command.velocity_mps = {speed_mps, 0};
  return command;
}

TEST(MixedRobots, HaveTheirOwnTopSpeedAndAcceleration) {
  Pair pair([](RobotSpec& slow) {
    slow.body.speed_mps = 2.2;
    slow.body.acceleration_mps2 = 1.5;
  });
  pair.command_both(forward(10));
  pair.frames(60);
  EXPECT_NEAR(pair.robot(kWest0).velocity_mps.x(), 1.5, 0.02);
  EXPECT_NEAR(pair.robot(kWest1).velocity_mps.x(), 3.0, 0.02);
  pair.frames(30);
  EXPECT_NEAR(pair.robot(kWest0).velocity_mps.x(), 2.2, 0.01);
}

TEST(MixedRobots, HaveTheirOwnHandicap) {
  Pair pair([](RobotSpec& lame) { lame.speed_factor = 0.5; });
  pair.command_both(forward(10));
  pair.frames(70);
  EXPECT_NEAR(pair.robot(kWest0).velocity_mps.x(), 1.5, 0.01);
  EXPECT_NEAR(pair.robot(kWest1).velocity_mps.x(), 3.0, 0.01);
}

TEST(MixedRobots, HaveTheirOwnKicker) {
  Pair pair([](RobotSpec& weak) { weak.kicker.speed_limit_mps = 2; });
  RobotCommand kick;
  kick.kick_mps = 5;
  pair.command_both(kick);
  EXPECT_NEAR(pair.kicked_by_mps(kWest0), 2.0, 0.01);
  EXPECT_NEAR(pair.kicked_by_mps(kWest1), 5.0, 0.01);
}

TEST(MixedRobots, ChargeTheirKickersIndependently) {
  Pair pair([](RobotSpec& slow) { slow.kicker.dead_time_s = 10; });
  RobotCommand kick;
  kick.kick_mps = 5;
  pair.command_both(kick);
  pair.play_ball_with(kWest0);
  pair.play_ball_with(kWest1);
  pair.play_ball_with(kWest0);
  pair.play_ball_with(kWest1);
  EXPECT_GT(pair.ball().velocity_mps.x(), 3.0);
  pair.play_ball_with(kWest0);
  EXPECT_LT(pair.ball().velocity_mps.x(), 0.5);
}

// How far the ball moves in a second in which that robot reverses with its dribbler on; robot 0's
// is broken.
double dribbled_m(RobotId id) {
  RobotCommand back = forward(-0.5);
  back.dribble = true;
  Pair pair([](RobotSpec& broken) { broken.dribbler.force_n = 0; });
  pair.command_both(back);
  pair.put_ball_at_plate(id);
  const double start_m = pair.ball().position_m.x();
  pair.frames(60);
  return pair.ball().position_m.x() - start_m;
}

TEST(MixedRobots, HaveTheirOwnDribbler) {
  EXPECT_NEAR(dribbled_m(kWest0), 0.0, 0.01);
  EXPECT_LT(dribbled_m(kWest1), -0.3);
}

// 2.5 kg at 2 m/s hits 5 kg at rest; 0.2 of the closing speed is kept.
TEST(MixedRobots, HaveTheirOwnMass) {
  Pair pair([](RobotSpec& heavy) { heavy.body.mass_kg = 5; });
  pair.put_robot(kWest0, {0.3, 0});
  pair.put_robot(kWest1, {0, 0}, {1, 0}, {2, 0});
  pair.command(kWest1).velocity_mps = {2, 0};
  const double fastest_mps = pair.most_over(6, [&] { return pair.robot(kWest0).velocity_mps.x(); });
  const double after_mps = 2.0 * 2.5 * (1.0 + 0.2) / (2.5 + 5.0);
  EXPECT_NEAR(fastest_mps, after_mps, 0.07);
}

// A robot gets its plate when the ball comes near and loses it later; Box2D then recomputes the
// mass.
TEST(MixedRobots, KeepTheirMassAfterTheBallHasComeAndGone) {
  Pair pair([](RobotSpec& heavy) { heavy.body.mass_kg = 5; });
  pair.put_ball({-1.7, 1});
  pair.frame();
  pair.put_ball({2, 1.5});
  pair.frame();
  pair.command_both(forward(3));
  pair.frames(30);
  EXPECT_NEAR(pair.robot(kWest0).velocity_mps.x(), 1.5, 0.02);
}

}  // namespace
}  // namespace autoref::sim
