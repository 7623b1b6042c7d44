#include "soccer/trigonometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autoref {
namespace {

TEST(Exponential, IsThatOfTheCLibraryUpToRounding) {
  for (double x = -40; x <= 40; x += 0.137)
    EXPECT_NEAR(exponential(x) / std::exp(x), 1, 1e-14) << x;
  EXPECT_NEAR(exponential(-700) / std::exp(-700), 1, 1e-12);
  EXPECT_NEAR(exponential(700) / std::exp(700), 1, 1e-12);
}

TEST(Exponential, IsExactAtZeroAndLimitedFarOut) {
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(1e9), exponential(700));
  EXPECT_EQ(exponential(-1e9), exponential(-700));
}

}  // namespace
}  // namespace autoref
