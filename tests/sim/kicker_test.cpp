#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/presets.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

// A robot at the origin that faces east and wants to kick.
struct Shot : Scene {
  explicit Shot(const RobotSpec& robot = quiet_robot(),
                const Configuration& configuration = quiet())
      : Scene(configuration, specs(1, 1, robot)) {
    put_robot(kWest0, {0, 0});
    command(kWest0).kick_mps = 4.0;
  }
  void put_ball_before(double gap_m, double aside_m) {
    put_ball({kFrontDistance_m + kBallRadius_m + gap_m, aside_m}, {0, 0}, true);
  }
};

TEST(Kicker, GivesTheBallTheCommandedSpeedOverGroundAlongTheHeading) {
  Shot shot;
  shot.put_ball_before(0.0, 0.0);
  shot.frame();
  EXPECT_NEAR(shot.ball().velocity_mps.x(), 4.0 - 3.4 * 4 / 240, 0.001);
  EXPECT_NEAR(shot.ball().velocity_mps.y(), 0.0, 1e-3);
  EXPECT_FALSE(shot.ball().is_rolling);
}

// A kick sends the ball forwards; across the plate, the ball keeps its own motion.
Vec2 kicked_while_moving_mps(const Vec2& ball_mps, bool chip = false) {
  RobotSpec strong = quiet_robot();
  strong.kicker.speed_limit_mps = 20;
  Shot shot(strong);
  shot.command(kWest0).chip = chip;
  shot.put_ball({kFrontDistance_m + kBallRadius_m, 0}, ball_mps, true);
  shot.frame();
  return shot.world.touches()[0].ball_mps;
}

TEST(Kicker, LeavesTheBallItsMotionAcrossTheHeading) {
  const Vec2 run_mps = kicked_while_moving_mps({0, 2});
  EXPECT_NEAR(run_mps.x(), 4.0, 1e-6);
  EXPECT_NEAR(run_mps.y(), 2.0, 0.02);
}

TEST(Kicker, DiscardsTheBallsMotionAlongTheHeading) {
  const Vec2 coming_mps = kicked_while_moving_mps({-3, -1});
  EXPECT_NEAR(coming_mps.x(), 4.0, 1e-6);
  EXPECT_NEAR(coming_mps.y(), -1.0, 0.02);
}

TEST(Kicker, LeavesAChippedBallItsMotionAcrossTheHeading) {
  const Vec2 chipped_mps = kicked_while_moving_mps({0, 2}, true);
  EXPECT_NEAR(chipped_mps.x(), 4.0 * std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(chipped_mps.y(), 2.0, 0.02);
}

bool fires_at(double gap_m, double aside_m) {
  Shot shot;
  shot.put_ball_before(gap_m, aside_m);
  shot.frame();
  return shot.ball().velocity_mps.x() > 3.0;
}

TEST(Kicker, FiresOnlyWithinItsReach) {
  EXPECT_TRUE(fires_at(0.014, 0));
  EXPECT_FALSE(fires_at(0.016, 0));
}

TEST(Kicker, FiresOnlyWithinItsDribblerZone) {
  EXPECT_TRUE(fires_at(0, 0.039));
  EXPECT_TRUE(fires_at(0, -0.039));
  EXPECT_FALSE(fires_at(0, 0.041));
}

TEST(Kicker, DoesNotFireWithoutACommand) {
  Shot shot;
  shot.command(kWest0).kick_mps = 0.0;
  shot.put_ball_before(0.0, 0.0);
  shot.frames(10);
  EXPECT_LT(shot.ball().velocity_mps.norm(), 0.05);
  EXPECT_TRUE(shot.world.touches().empty() || !shot.world.touches()[0].is_kick);
}

// Puts the ball before the robot in each frame. Returns the frames with a kick.
std::vector<int> frames_with_kick(Shot& shot, int frames) {
  std::vector<int> with_kick;
  for (int f = 0; f < frames; ++f) {
    shot.put_ball_before(0.0, 0.0);
    shot.frame();
    if (shot.ball().velocity_mps.x() > 3.0) with_kick.push_back(f);
  }
  return with_kick;
}

TEST(Kicker, NeedsOneTenthOfASecondBetweenKicks) {
  Shot shot;
  EXPECT_EQ(frames_with_kick(shot, 12), std::vector({0, 6}));  // 24 sub-steps apart
}

TEST(Kicker, CannotExceedEightMetresPerSecond) {
  Shot shot;
  shot.command(kWest0).kick_mps = 20.0;
  shot.put_ball_before(0.0, 0.0);
  shot.frame();
  EXPECT_GT(shot.ball().velocity_mps.norm(), 7.9);
  EXPECT_LE(shot.ball().velocity_mps.norm(), 8.0);
}

TEST(Kicker, ChipsAtFortyFiveDegrees) {
  Shot shot;
  shot.command(kWest0).chip = true;
  shot.put_ball_before(0.0, 0.0);
  shot.frame();
  EXPECT_NEAR(shot.ball().velocity_mps.x(), 4.0 * std::sqrt(0.5), 0.001);
  EXPECT_NEAR(shot.ball().vertical_mps, 4.0 * std::sqrt(0.5) - 9.81 / 60, 0.001);
}

TEST(Kicker, ChipsAtMostFiveAndAHalfMetresPerSecond) {
  Shot shot;
  shot.command(kWest0).chip = true;
  shot.command(kWest0).kick_mps = 8.0;
  shot.put_ball_before(0.0, 0.0);
  shot.frame();
  EXPECT_NEAR(shot.ball().velocity_mps.x(), 5.5 * std::sqrt(0.5), 0.001);
}

TEST(Kicker, DoesNotReachABallInTheAir) {
  Shot shot;
  BallState ball;
  ball.position_m = {kFrontDistance_m + kBallRadius_m, 0.0};
  ball.height_m = 0.1;
  shot.world.put_ball(ball);
  shot.frame();
  EXPECT_LT(shot.ball().velocity_mps.norm(), 0.5);
}

// 46 g at 4 m/s against 2.5 kg.
TEST(Kicker, PushesTheRobotBackByTheBallsMomentum) {
  Configuration one = quiet();
  one.substeps = 1;
  RobotSpec still = quiet_robot();
  still.body.acceleration_mps2 = 1e-6;
  still.body.braking_mps2 = 1e-6;
  Shot shot(still, one);
  shot.put_ball_before(0.005, 0.0);
  shot.frame();
  EXPECT_NEAR(shot.robot(kWest0).velocity_mps.x(), -0.046 * 4.0 / 2.5, 1e-4);
}

TEST(Kicker, ScattersByTwoAndAHalfPercentAndOneAndAHalfDegrees) {
  RobotSpec noisy = quiet_robot();
  noisy.kicker = KickerParameters{};
  Shot shot(noisy);
  double speed2 = 0.0;
  double angle2 = 0.0;
  constexpr int kKicks = 400;
  for (int i = 0; i < kKicks; ++i) {
    shot.put_ball_before(0.005, 0.0);
    shot.put_robot(kWest0, {0, 0});
    shot.frame();
    const Vec2& v = shot.ball().velocity_mps;
    speed2 += std::pow((v.norm() + 3.4 * 4 / 240) / 4.0 - 1.0, 2);
    angle2 += std::pow(std::atan2(v.y(), v.x()) * 180.0 / kPi, 2);
    shot.frames(6);
  }
  EXPECT_NEAR(std::sqrt(speed2 / kKicks), 0.025, 0.004);
  EXPECT_NEAR(std::sqrt(angle2 / kKicks), 1.5, 0.2);
}

TEST(Kicker, ScattersTheElevationOfChips) {
  RobotSpec noisy = quiet_robot();
  noisy.kicker.chip_angle_noise_deg = 6.0;
  Shot shot(noisy);
  shot.command(kWest0).chip = true;
  double angle2 = 0.0;
  constexpr int kKicks = 400;
  for (int i = 0; i < kKicks; ++i) {
    shot.put_ball_before(0.005, 0.0);
    shot.put_robot(kWest0, {0, 0});
    shot.frame();
    const double up_mps = shot.ball().vertical_mps + 9.81 / 60;
    const double along_mps = shot.ball().velocity_mps.x();
    EXPECT_NEAR(std::hypot(up_mps, along_mps), 4.0, 0.01);
    angle2 += std::pow(std::atan2(up_mps, along_mps) * 180.0 / kPi - 45.0, 2);
    shot.frames(6);
  }
  EXPECT_NEAR(std::sqrt(angle2 / kKicks), 6.0, 0.9);  // four standard deviations
}

TEST(KickerPresets, HaveTheirParameters) {
  KickerParameters kicker;
  EXPECT_EQ(kicker_preset_of(kicker), "default");
  apply_kicker_preset("rc2026", kicker);
  EXPECT_EQ(kicker.direction_noise_deg, 2.9);
  EXPECT_EQ(kicker_preset_of(kicker), "rc2026");
  kicker.direction_noise_deg = 2;
  EXPECT_EQ(kicker_preset_of(kicker), std::nullopt);
  EXPECT_THROW(apply_kicker_preset("hard", kicker), std::invalid_argument);
}

TEST(TwoKickersAtOnce, AddUpInAnyOrder) {
  Shot shot;
  shot.put_ball({0, 0}, {0, 0}, true);
  shot.put_robot(kWest0, {-0.1, 0}, {1, 0});
  shot.put_robot(kEast0, {0.1, 0}, {-1, 0});
  shot.command(kEast0).kick_mps = 4.0;
  shot.frame();
  EXPECT_NEAR(shot.ball().velocity_mps.norm(), 0.0, 0.01);
}

TEST(Dribbler, HoldsTheBallInGentleMotion) {
  Shot shot;
  shot.command(kWest0).kick_mps = 0.0;
  shot.command(kWest0).dribble = true;
  shot.put_ball_before(0.0, 0.0);
  for (int f = 0; f < 240; ++f) {  // forward, back, and turning
    shot.command(kWest0).velocity_mps = {f < 60 ? 0.8 : f < 120 ? -0.8 : 0.3, 0.0};
    shot.command(kWest0).angular_velocity_radps = f < 120 ? 0.0 : 1.5;
    shot.frame();
    const RobotState& robot = shot.robot(kWest0);
    ASSERT_LT(distance_to_hull(shot.ball().position_m, robot.position_m, robot.heading), 0.032)
        << f;
  }
}

// Turning on the spot at w needs 46 g * 96.5 mm * w^2 to keep the ball on its circle: 0.16 N at 6
// rad/s, 0.28 N at 8, plus the carpet's friction of up to 0.16 N.
double gap_after_turning_m(double turn_radps) {
  Shot shot;
  shot.command(kWest0).kick_mps = 0.0;
  shot.command(kWest0).dribble = true;
  shot.put_ball_before(0.0, 0.0);
  shot.command(kWest0).angular_velocity_radps = turn_radps;
  shot.frames(60);
  const RobotState& robot = shot.robot(kWest0);
  return distance_to_hull(shot.ball().position_m, robot.position_m, robot.heading) - kBallRadius_m;
}

TEST(Dribbler, LosesTheBallOnlyInAHardTurn) {
  EXPECT_LE(gap_after_turning_m(6.0), 0.05);
  EXPECT_GT(gap_after_turning_m(8.0), 0.05);
}

double rebound_mps(bool dribbles) {
  RobotSpec weak = quiet_robot();
  weak.dribbler.force_n = 0.0;
  Shot shot(weak);
  shot.command(kWest0).kick_mps = 0.0;
  shot.command(kWest0).dribble = dribbles;
  shot.put_ball({0.15, 0}, {-3.0, 0}, false);
  shot.frames(2);
  return shot.ball().velocity_mps.x();
}

TEST(Dribbler, AbsorbsMoreOfAnArrivingBallsSpeed) {
  EXPECT_NEAR(rebound_mps(false), 0.4 * 3.0, 0.15);
  EXPECT_NEAR(rebound_mps(true), 0.2 * 3.0, 0.15);
}

}  // namespace
}  // namespace autoref::sim
