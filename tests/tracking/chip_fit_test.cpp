#include "tracking/chip_flight.hpp"

#include <gtest/gtest.h>

namespace autoref::tracking {
namespace {

// A ball that rolled at `before_mps` leaves a robot at `after_mps`. It keeps its spin at first, so
// the carpet decelerates it by 3.4 m/s2 against the change of its velocity.
CarpetSums deflected(const Vec2& before_mps, const Vec2& after_mps) {
  CarpetSums sums;
  const Vec2 braking_mps2 = -3.4 * (after_mps - before_mps).normalized();
  for (int n = 1; n <= 8; ++n) {
    const double t_s = n / 60.0;
    sums.add_detection(t_s, after_mps * t_s + braking_mps2 * (t_s * t_s / 2));
  }
  return sums;
}

// Across its first direction the ball strays by up to 30 mm, the noise is 1.4 mm.
TEST(CarpetSums, FitTheCurvedPathOfABallThatKeepsItsSpin) {
  const Vec2 before_mps(-1.96, -1.79);
  const CarpetSums sums = deflected(before_mps, {0.67, -0.84});
  const double noise_m2 = square(1.4_mm);
  EXPECT_GT(sums.misfit(1, Vec2(0, 0)), 20 * noise_m2);
  EXPECT_LT(sums.misfit(1, before_mps), noise_m2);
}

TEST(CarpetSums, FitTheStraightPathOfABallThatLay) {
  const CarpetSums sums = deflected({0, 0}, {2, 1});
  EXPECT_LT(sums.misfit(1, Vec2(0, 0)), square(0.01_mm));
}

CarpetSums sums_of_accelerating_ball() {
  CarpetSums sums;
  for (int n = 1; n <= 8; ++n) {
    const double t_s = n / 60.0;
    sums.add_detection(t_s, Vec2(2 * t_s + 3 * t_s * t_s, 0));
  }
  return sums;
}

// A flying ball may seem to accelerate, which no carpet does.
TEST(CarpetSums, DoNotFitABallThatAcceleratesAlongItsPath) {
  const CarpetSums sums = sums_of_accelerating_ball();
  EXPECT_GT(sums.misfit(1, Vec2(0, 0)), square(1.4_mm));
  EXPECT_GT(sums.misfit(1, Vec2(-1, 0)), square(1.4_mm));
}

}  // namespace
}  // namespace autoref::tracking
