#include "logs/fit/kick_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kKickInterval_s = 1 / 60.0;
constexpr std::size_t kFramesPerKick = 21;  // per kick
constexpr std::size_t kKickFrame = 10;
constexpr double kKickHeadingNoise_rad = 0.02;
constexpr double kBallAtPlate_m = kFrontDistance_m + kBallRadius_m;

// A robot kicks again and again. Before that, the ball lies `gap_m` in front of its plate.
class RepeatedKicks {
 public:
  explicit RepeatedKicks(double gap_m = 0) : gap_m_(gap_m) {
    motion_.interval_s = kKickInterval_s;
    motion_.ball_noise_m = 1_mm;
    motion_.robots.resize(1);
  }

  void move_left(double speed_mps) { left_mps_ = speed_mps; }
  // Before the kick, the ball slides along the plate.
  void slide_left(double speed_mps) { sliding_mps_ = speed_mps; }
  // Afterwards, the robot turns from the kick on.
  void turn_after_kicks(double speed_radps) { turning_radps_ = speed_radps; }

  void kick(double off_rad) {
    const double speed_mps = 4;
    for (std::size_t i = 0; i < kFramesPerKick; ++i) {
      const double since_s = kKickInterval_s * (static_cast<double>(i) - kKickFrame);
      RobotSight robot;
      robot.position_m = {0, left_mps_ * since_s};
      robot.heading_rad =
          kKickHeadingNoise_rad * random_.normal() + turning_radps_ * std::max(since_s, 0.0);
      robot.is_seen = robot.is_known = true;
      robot.time_s = kKickInterval_s * static_cast<double>(motion_.times_s.size());
      BallSight ball;
      ball.position_m =
          robot.position_m + Vec2(kBallAtPlate_m + gap_m_, sliding_mps_ * std::min(since_s, 0.0));
      ball.is_seen = true;
      ball.time_s = robot.time_s;
      motion_.robots[0].sights.push_back(robot);
      motion_.ball.push_back(ball);
      motion_.times_s.push_back(robot.time_s);
    }
    // The ball's speed along the plate changes a little until the kick.
    const double along_mps = left_mps_ + sliding_mps_ + 0.05 * random_.normal();
    const Vec2 velocity_mps = speed_mps * heading_of(off_rad) + Vec2(0, along_mps);
    Kick kick;
    kick.time_s = motion_.times_s[motion_.times_s.size() - kFramesPerKick + kKickFrame];
    kick.speed_mps = velocity_mps.norm();
    kick.direction = velocity_mps.normalized();
    kicks_.push_back(kick);
  }

  void kick_often(int kicks, double spread_deg) {
    for (int i = 0; i < kicks; ++i) kick(to_radians(spread_deg) * random_.normal());
  }

  Estimate noise_deg() const {
    KickFit fit;
    fit.add(motion_, kicks_);
    return fit.direction_noise_deg(kKickHeadingNoise_rad);
  }

 private:
  double gap_m_;
  double left_mps_ = 0;
  double sliding_mps_ = 0;
  double turning_radps_ = 0;
  RecordedMotion motion_;
  std::vector<Kick> kicks_;
  RandomStream random_{3};
};

void expect_near_in_kicks(const Estimate& estimate, double truth, double tolerance) {
  ASSERT_TRUE(estimate.number.has_value());
  EXPECT_NEAR(estimate.number->value, truth, tolerance);
  EXPECT_LT(estimate.number->low, truth);
  EXPECT_GT(estimate.number->high, truth);
  EXPECT_LT(estimate.number->high - estimate.number->low, truth);
}

TEST(KickFit, EstimatesSpreadOfDirections) {
  RepeatedKicks kicks;
  kicks.kick_often(80, 2);
  EXPECT_EQ(kicks.noise_deg().episodes, 80);
  expect_near_in_kicks(kicks.noise_deg(), 2, 0.4);
}

TEST(KickFit, DoesNotReportErrorsOfHeadingsAsSpread) {
  RepeatedKicks kicks;
  kicks.kick_often(80, 0);
  ASSERT_TRUE(kicks.noise_deg().number.has_value());
  EXPECT_LT(kicks.noise_deg().number->value, 0.3);
}

TEST(KickFit, IgnoresDeflections) {
  RepeatedKicks kicks;
  kicks.kick_often(80, 2);
  for (int i = 0; i < 8; ++i) kicks.kick(25_deg);
  expect_near_in_kicks(kicks.noise_deg(), 2, 0.5);
}

TEST(KickFit, AllowsForMotionOfPlate) {
  RepeatedKicks kicks;
  for (int i = 0; i < 80; ++i) {
    kicks.move_left(i % 2 == 0 ? 0.5 : -0.5);
    kicks.kick_often(1, 2);
  }
  expect_near_in_kicks(kicks.noise_deg(), 2, 0.5);
}

TEST(KickFit, AllowsForBallsThatSlideAlongThePlate) {
  RepeatedKicks kicks;
  for (int i = 0; i < 80; ++i) {
    kicks.slide_left(i % 2 == 0 ? 0.2 : -0.2);
    kicks.kick_often(1, 2);
  }
  expect_near_in_kicks(kicks.noise_deg(), 2.2, 0.5);  // the plate's speed counts, too
}

TEST(KickFit, IsNotMisledByTurnsAfterKicks) {
  RepeatedKicks kicks;
  for (int i = 0; i < 80; ++i) {
    kicks.turn_after_kicks(i % 2 == 0 ? 6 : -6);
    kicks.kick_often(1, 2);
  }
  expect_near_in_kicks(kicks.noise_deg(), 2, 0.5);
}

TEST(KickFit, NeedsTwelveKicksOfHeldBall) {
  RepeatedKicks few;
  few.kick_often(11, 2);
  EXPECT_EQ(few.noise_deg().episodes, 11);
  EXPECT_FALSE(few.noise_deg().number.has_value());
  few.kick_often(1, 2);
  EXPECT_TRUE(few.noise_deg().number.has_value());

  RepeatedKicks far_balls(60_mm);
  far_balls.kick_often(40, 2);
  EXPECT_EQ(far_balls.noise_deg().episodes, 0);
}

}  // namespace
}  // namespace autoref::logs
