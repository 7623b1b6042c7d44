#include "soccer/trigonometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/random.hpp"
#include "soccer/units.hpp"

namespace autoref {
namespace {

TEST(Trigonometry, SineAndCosineAgreeWithTheLibraryOverManyTurns) {
  RandomStream random(1);
  for (int i = 0; i < 100000; ++i) {
    const double angle_rad = (random.uniform() - 0.5) * 2e5;
    const auto [s, c] = sin_cos(angle_rad);
    ASSERT_NEAR(s, std::sin(angle_rad), 4e-16) << angle_rad;
    ASSERT_NEAR(c, std::cos(angle_rad), 4e-16) << angle_rad;
  }
}

TEST(Trigonometry, AngleOfAVectorAgreesWithTheLibrary) {
  RandomStream random(2);
  for (int i = 0; i < 100000; ++i) {
    const double y = random.uniform() - 0.5;
    const double x = random.uniform() - 0.5;
    ASSERT_NEAR(atan2_exact(y, x), std::atan2(y, x), 1e-15) << y << ' ' << x;
  }
}

TEST(Trigonometry, AngleIsExactAlongTheAxesAndZeroForTheZeroVector) {
  EXPECT_EQ(atan2_exact(0, 0), 0);
  EXPECT_EQ(atan2_exact(0, 2), 0);
  EXPECT_NEAR(atan2_exact(3, 0), kPi / 2, 1e-15);
  EXPECT_NEAR(std::abs(atan2_exact(0, -1)), kPi, 1e-15);
}

TEST(Trigonometry, WrappingBringsAnglesIntoOneTurn) {
  EXPECT_NEAR(wrap_angle(3 * kPi / 2), -kPi / 2, 1e-15);
  EXPECT_NEAR(std::abs(wrap_angle(-5 * kPi)), kPi, 1e-14);
  EXPECT_EQ(wrap_angle(1.0), 1.0);
}

}  // namespace
}  // namespace autoref
