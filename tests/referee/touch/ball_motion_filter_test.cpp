// The ball's motion while only the carpet acts on it.
#include "referee/touch/hull_intersections.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"
#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

constexpr BallMotionParameters kParameters;

// Position of a ball that moves along x from the origin with constant deceleration.
Vec2 slowed(double speed_mps, double slowed_by_mps2, double time_s) {
  return {speed_mps * time_s - slowed_by_mps2 / 2 * time_s * time_s, 0};
}

// The filter after tracking that ball without noise for `frames` frames.
BallMotionFilter motion_of(double speed_mps, double slowed_by_mps2, int frames,
                           bool rolls = false) {
  BallMotionFilter motion;
  motion.start({0, 0}, kParameters);
  for (int i = 1; i <= frames; ++i) {
    motion.predict(kFrame_s, kParameters);
    if (rolls && i == 2) motion.begin_to_roll(kParameters);
    motion.correct(slowed(speed_mps, slowed_by_mps2, i * kFrame_s), kParameters);
  }
  return motion;
}

double velocity_off_mps(const BallMotionFilter& motion) {
  return std::sqrt(motion.velocity_variance_m2ps2());
}
double position_off_m(const BallMotionFilter& motion) {
  return std::sqrt(motion.position_variance_after(0));
}

TEST(BallMotionFilter, StartsWithAVelocityPriorThatCoversKicks) {
  BallMotionFilter motion;
  motion.start({1, 2}, kParameters);
  EXPECT_EQ(motion.position_after(0), Vec2(1, 2));
  EXPECT_EQ(motion.velocity_mps(), Vec2(0, 0));
  // A kick at 8 m/s, the limit of the Laws, is about two standard deviations.
  EXPECT_NEAR(velocity_off_mps(motion), 4, 2);
}

TEST(BallMotionFilter, EstimatesTheVelocityFromTwoDetections) {
  const BallMotionFilter motion = motion_of(3, 0, 1);
  EXPECT_NEAR(motion.velocity_mps().x(), 3, 0.02);
  // Noise of 0.2 mm in two detections and friction during half a frame contribute 17 mm/s each.
  EXPECT_NEAR(velocity_off_mps(motion), 0.025, 0.01);
}

TEST(BallMotionFilter, EstimatesTheDecelerationOfASlidingBall) {
  const BallMotionFilter motion = motion_of(4, 3.5, 15);
  EXPECT_NEAR(motion.velocity_mps().x(), 4 - 3.5 * 15 * kFrame_s, 0.02);
  const double ahead_s = 0.1;
  EXPECT_NEAR(motion.position_after(ahead_s).x(), slowed(4, 3.5, 15 * kFrame_s + ahead_s).x(),
              0.003);
}

// A sliding ball decelerates by 3.0 to 3.9 m/s2. Half of that times the time squared, 30 to 55 mm
// after ten frames, should be about two standard deviations of the position.
TEST(BallMotionFilter, AllowsForTheDecelerationOfSliding) {
  BallMotionFilter motion = motion_of(4, 0, 1);
  const BallMotionFilter known = motion;
  motion.predict(10 * kFrame_s, kParameters);
  const double by_velocity_m = velocity_off_mps(known) * 10 * kFrame_s;
  const double off_m = std::sqrt(std::pow(position_off_m(motion), 2) - std::pow(by_velocity_m, 2));
  EXPECT_GT(2 * off_m, 0.03);
  EXPECT_LT(2 * off_m, 0.12);
}

// Predicts frame by frame, without detections.
void go_unseen(BallMotionFilter& motion, double duration_s) {
  const int frames = static_cast<int>(duration_s / kFrame_s + 0.5);
  for (int i = 0; i < frames; ++i) motion.predict(kFrame_s, kParameters);
}

// Within a second sliding may end or the spin may change direction, which changes the deceleration
// by 1 m/s2. Integrated over that second, the velocity error is 1 m/s divided by the square root of
// three.
TEST(BallMotionFilter, ForgetsTheDecelerationOfASlidingBall) {
  BallMotionFilter motion = motion_of(4, 3.5, 60);
  go_unseen(motion, 1);
  EXPECT_NEAR(velocity_off_mps(motion), 1 / std::sqrt(3.0), 0.25);
}

// Carpets are uniform: the deceleration of a rolling ball drifts by 0.14 m/s2 in 4 s.
TEST(BallMotionFilter, HardlyForgetsTheDecelerationOfARollingBall) {
  BallMotionFilter motion = motion_of(3, 0.3, 120, true);
  go_unseen(motion, 4);
  EXPECT_NEAR(velocity_off_mps(motion), 0.14 * 4 / std::sqrt(3.0), 0.15);
}

TEST(BallMotionFilter, KeepsRollingWithTheCarpetsDeceleration) {
  const BallMotionFilter motion = motion_of(1, 0.3, 30, true);
  ASSERT_TRUE(motion.rolls());
  const double ahead_s = 1;
  EXPECT_NEAR(motion.position_after(ahead_s).x(), slowed(1, 0.3, 30 * kFrame_s + ahead_s).x(),
              0.02);
}

// On the league's carpets, a rolling ball decelerates by 0.1 to 0.5 m/s2.
TEST(BallMotionFilter, AssumesATypicalCarpetWhenTheBallBeginsToRoll) {
  BallMotionFilter motion = motion_of(2, 0, 30);
  motion.begin_to_roll(kParameters);
  motion.predict(1, kParameters);
  EXPECT_NEAR(motion.velocity_mps().x(), 2 - 0.3, 0.02);
  // The deceleration is wrong by 0.2 m/s2 for a second, and sliding for part of a frame adds 20
  // mm/s.
  EXPECT_NEAR(velocity_off_mps(motion), 0.2, 0.08);
}

TEST(BallMotionFilter, ChangesVelocityOnlySlightlyWhenRollingBegins) {
  BallMotionFilter motion = motion_of(2, 0, 60);
  const double before_mps = velocity_off_mps(motion);
  motion.begin_to_roll(kParameters);
  const double grown_mps =
      std::sqrt(std::pow(velocity_off_mps(motion), 2) - std::pow(before_mps, 2));
  // Sliding for a third of a frame: 3.5 m/s2 times 6 ms.
  EXPECT_NEAR(grown_mps, 0.02, 0.01);
}

TEST(BallMotionFilter, StopsARollingBall) {
  BallMotionFilter motion = motion_of(0.1, 0.3, 12, true);
  motion.predict(2, kParameters);
  const Vec2 rests_m = motion.position_after(0);
  motion.predict(2, kParameters);
  EXPECT_EQ(motion.velocity_mps(), Vec2(0, 0));
  EXPECT_EQ(motion.position_after(0), rests_m);
}

TEST(BallMotionFilter, AllowsForAKickAtAHardTouch) {
  BallMotionFilter motion = motion_of(1, 0, 30);
  motion.touch(kFrame_s, false, kParameters);
  EXPECT_FALSE(motion.rolls());
  // Bounces change the velocity by about 1 m/s, kicks by up to 8 m/s, five standard deviations.
  EXPECT_NEAR(velocity_off_mps(motion), 1.5, 0.8);
}

TEST(BallMotionFilter, KeepsRollingAfterASoftTouch) {
  BallMotionFilter motion = motion_of(1, 0.3, 30, true);
  motion.touch(kFrame_s, true, kParameters);
  EXPECT_TRUE(motion.rolls());
  // A ball at 1 m/s that is deflected by 8 degrees.
  EXPECT_NEAR(velocity_off_mps(motion), 0.14, 0.06);
}

// The touch may be at any time within the frame, so the new velocity acts for an unknown part of
// it.
TEST(BallMotionFilter, AllowsForAnUnknownTimeOfTheTouch) {
  BallMotionFilter motion = motion_of(1, 0, 30);
  const double before_m = position_off_m(motion);
  motion.touch(kFrame_s, false, kParameters);
  const double grown_m = std::sqrt(std::pow(position_off_m(motion), 2) - std::pow(before_m, 2));
  EXPECT_NEAR(grown_m, 1.5 * kFrame_s / std::sqrt(3.0), 1e-3);
}

TEST(BallMotionFilter, AllowsForAPositionErrorOfACentimetreAtTakeoff) {
  BallMotionFilter motion;
  motion.jump({0, 0}, kParameters);
  EXPECT_NEAR(position_off_m(motion), 0.01, 0.005);
}

TEST(BallMotionFilter, RunsBackwardsLikeForwards) {
  BallMotionFilter motion;
  motion.start(slowed(3, 3.5, 10 * kFrame_s), kParameters);
  for (int i = 9; i >= 0; --i) {
    motion.predict(-kFrame_s, kParameters);
    motion.correct(slowed(3, 3.5, i * kFrame_s), kParameters);
  }
  EXPECT_NEAR(motion.velocity_mps().x(), 3, 0.03);
  EXPECT_NEAR(motion.position_after(0).x(), 0, 1e-3);
}

TEST(BallMotionFilter, HasADevianceThatGrowsWithTheSquaredInnovation) {
  BallMotionFilter on = motion_of(2, 0, 30);
  BallMotionFilter off = on;
  const Vec2 next_m = slowed(2, 0, 31 * kFrame_s);
  on.predict(kFrame_s, kParameters);
  off.predict(kFrame_s, kParameters);
  const double off_m = 5 * std::sqrt(off.position_variance_after(0) + std::pow(0.2e-3, 2));
  const double more =
      off.correct(next_m + Vec2(0, off_m), kParameters) - on.correct(next_m, kParameters);
  EXPECT_NEAR(more, 25, 2);  // five standard deviations, squared
}

// If all standard deviations are ten times smaller, the deviance of an exact hit in two coordinates
// is smaller by 4 log 10.
TEST(BallMotionFilter, HasADevianceThatGrowsWithTheVariance) {
  BallMotionParameters coarse = kParameters;
  coarse.detection_m = 10 * kParameters.detection_m;
  BallMotionFilter fine_motion;
  BallMotionFilter coarse_motion;
  fine_motion.start({0, 0}, kParameters);
  coarse_motion.start({0, 0}, coarse);
  const double more =
      coarse_motion.correct({0, 0}, coarse) - fine_motion.correct({0, 0}, kParameters);
  EXPECT_NEAR(more, 4 * std::log(10.0), 1e-5);
}

TEST(BallMotionFilter, HasErrorsConsistentWithItsCovariance) {
  BallMotionParameters noisy = kParameters;
  noisy.detection_m = 0.0014;
  RandomStream random(1);
  int within = 0;
  for (int run = 0; run < 200; ++run) {
    BallMotionFilter motion;
    for (int i = 0; i <= 20; ++i) {
      const double x_m = noisy.detection_m * random.normal();
      const double y_m = noisy.detection_m * random.normal();
      const Vec2 seen_m = slowed(3, 3.5, i * kFrame_s) + Vec2(x_m, y_m);
      if (i == 0) {
        motion.start(seen_m, noisy);
        continue;
      }
      motion.predict(kFrame_s, noisy);
      motion.correct(seen_m, noisy);
    }
    const double off_mps = std::abs(motion.velocity_mps().x() - (3 - 3.5 * 20 * kFrame_s));
    within += off_mps <= 2 * velocity_off_mps(motion) ? 1 : 0;
  }
  EXPECT_GE(within, 180);
}

}  // namespace
}  // namespace autoref::referee
