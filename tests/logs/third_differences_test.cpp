#include "logs/third_differences.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

TEST(NoiseIn, FindsTheDeviationBehindThirdDifferences) {
  RandomStream random(3);
  std::vector<double> differences;
  for (int i = 0; i < 5000; ++i) {
    const double noise[] = {random.normal(), random.normal(), random.normal(), random.normal()};
    differences.push_back(std::abs(third_difference(noise[0], noise[1], noise[2], noise[3])));
  }
  EXPECT_NEAR(noise_in(differences), 1, 0.03);
}

}  // namespace
}  // namespace autoref::logs
