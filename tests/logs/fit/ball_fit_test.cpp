#include "logs/fit/ball_fit.hpp"

#include <gtest/gtest.h>

#include "logs/fit/kicks.hpp"
#include "tests/logs/fit/rolled_balls.hpp"

namespace autoref::logs {
namespace {

sim::BallParameters known_ball() {
  sim::BallParameters ball;
  ball.roll_mps2 = 0.35;
  ball.slide_mps2 = 4.2;
  ball.switch_ratio = 0.63;
  return ball;
}

void expect_close(const Estimate& estimate, double truth, double share) {
  ASSERT_TRUE(estimate.number);
  const double half = (estimate.number->high - estimate.number->low) / 2;
  EXPECT_NEAR(estimate.number->value, truth, 2 * half);  // four standard deviations
  EXPECT_LT(half, share * truth);
  EXPECT_GT(estimate.episodes, 0);
}

TEST(FreeStretches, FindsBothPhasesOfAKick) {
  RolledBalls balls(known_ball());
  balls.kick(4, 1.5);
  const std::vector<FreeStretch> stretches = free_stretches_in(balls.motion());
  ASSERT_EQ(stretches.size(), 1U);
  const FreeStretch& stretch = stretches.front();
  EXPECT_TRUE(stretch.is_straight);
  EXPECT_TRUE(stretch.has_two_phases());
  EXPECT_FALSE(stretch.has_one_phase());
  EXPECT_NEAR(stretch.two->first_mps2.value, 4.2, 0.5);
  EXPECT_NEAR(stretch.two->second_mps2.value, 0.35, 0.05);
  EXPECT_NEAR(stretch.direction.x(), 1, 0.01);
}

TEST(FreeStretches, EndAtRobots) {
  RolledBalls balls(known_ball());
  balls.kick(4, 1.5);
  const std::vector<FreeStretch> stretches = free_stretches_in(balls.motion());
  ASSERT_EQ(stretches.size(), 1U);
  for (const std::size_t frame : stretches.front().frames)
    EXPECT_GT(balls.motion().nearest_m[frame], kRobotRadius_m + kBallRadius_m);
}

TEST(FreeStretches, DoNotCallABentPathStraight) {
  RolledBalls balls(known_ball());
  for (int i = 0; i < 9; ++i) balls.roll(2, 1);
  RecordedMotion motion = balls.motion();
  const std::size_t frames = free_stretches_in(motion).front().frames.size();
  for (std::size_t i = frames / 2; i < frames; ++i)
    motion.ball[i].position_m.y() += 0.01 * static_cast<double>(i - frames / 2);
  const std::vector<FreeStretch> stretches = free_stretches_in(motion);
  ASSERT_EQ(stretches.size(), 9U);
  EXPECT_FALSE(stretches[0].is_straight);
  EXPECT_TRUE(stretches[1].is_straight);
}

TEST(BallFit, FindsHowTheBallRolls) {
  RolledBalls balls(known_ball());
  for (int i = 0; i < 20; ++i) balls.roll(0.8 + 0.1 * i, 1.5);
  BallFit fit;
  fit.add(balls.motion());
  expect_close(fit.roll().roll_mps2, 0.35, 0.03);
  EXPECT_GE(fit.roll().roll_mps2.episodes, 18);  // noise may hide that one has a single phase
  EXPECT_LE(fit.roll().roll_mps2.episodes, 20);
  ASSERT_TRUE(fit.roll().roll_per_s.number);
  EXPECT_NEAR(fit.roll().roll_per_s.number->value, 0, 0.01);
  EXPECT_EQ(fit.slide_mps2().number, std::nullopt);
}

TEST(BallFit, FindsDragThatGrowsWithTheSpeed) {
  sim::BallParameters ball = known_ball();
  ball.roll_mps2 = 0.22;
  ball.roll_per_s = 0.1;
  RolledBalls balls(ball);
  for (int i = 0; i < 30; ++i) balls.roll(0.8 + 0.1 * i, 1.5);
  BallFit fit;
  fit.add(balls.motion());
  expect_close(fit.roll().roll_mps2, 0.22, 0.05);
  expect_close(fit.roll().roll_per_s, 0.1, 0.05);
}

TEST(BallFit, FindsSlidingAndTheSwitchRatio) {
  RolledBalls balls(known_ball());
  for (int i = 0; i < 20; ++i) balls.kick(2 + 0.2 * i, 1.6, 0.02 * (i % 5));
  BallFit fit;
  fit.add(balls.motion());
  expect_close(fit.slide_mps2(), 4.2, 0.03);
  const std::vector<Kick> kicks = kicks_in(balls.motion(), known_ball());
  ASSERT_EQ(kicks.size(), 20U);
  EXPECT_NEAR(kicks[5].speed_mps, 3, 0.1);
  EXPECT_NEAR(kicks[1].angle_rad, -0.02, 0.005);
  EXPECT_NEAR(kicks[1].direction_error_rad, 0.0003, 0.0002);
  expect_close(switch_ratio_of(kicks), 0.63, 0.02);
}

TEST(BallFit, AFewStretchesAreNotEnough) {
  RolledBalls balls(known_ball());
  for (int i = 0; i < 2; ++i) balls.roll(1 + i, 1.5);
  BallFit fit;
  fit.add(balls.motion());
  EXPECT_EQ(fit.roll().roll_mps2.number, std::nullopt);
  EXPECT_EQ(fit.roll().roll_mps2.episodes, 2);
  EXPECT_EQ(fit.roll_prediction({}), std::nullopt);
}

TEST(BallFit, PredictsPathsBetterThanAnotherBall) {
  RolledBalls balls(known_ball());
  for (int i = 0; i < 12; ++i) balls.roll(1 + 0.1 * i, 2);
  BallFit fit;
  fit.add(balls.motion());
  sim::BallParameters other;
  other.roll_mps2 = 0.6;
  const auto prediction = fit.roll_prediction(other);
  ASSERT_TRUE(prediction);
  EXPECT_EQ(prediction->paths, 12);
  EXPECT_LT(prediction->fitted_m, 0.02);
  EXPECT_GT(prediction->compared_m, 5 * prediction->fitted_m);
}

}  // namespace
}  // namespace autoref::logs
