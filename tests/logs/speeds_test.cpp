#include "logs/speeds.hpp"

#include <gtest/gtest.h>

namespace autoref::logs {
namespace {

TEST(SpeedDistribution, KnowsItsMeanAndQuantiles) {
  SpeedDistribution speeds;
  EXPECT_EQ(speeds.mean_mps(), 0);
  EXPECT_EQ(speeds.quantile_mps(0.99), 0);
  for (int i = 0; i < 100; ++i) speeds.add(i < 98 ? 1.005 : 4.005);
  EXPECT_NEAR(speeds.mean_mps(), 1.065, 1e-9);
  EXPECT_NEAR(speeds.quantile_mps(0.5), 1.01, 1e-9);
  EXPECT_NEAR(speeds.quantile_mps(0.99), 4.01, 1e-9);
}

TEST(SpeedDistribution, LimitsImpossibleSpeeds) {
  SpeedDistribution speeds;
  speeds.add(1e6);
  EXPECT_NEAR(speeds.quantile_mps(1), 20, 1e-9);
}

}  // namespace
}  // namespace autoref::logs
