#include "soccer/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace autoref {
namespace {

TEST(RandomStream, GivesTheSameNumbersForTheSameKey) {
  RandomStream one = RandomStream::of(7, RandomPurpose::kKicker, Side::kWest);
  RandomStream two = RandomStream::of(7, RandomPurpose::kKicker, Side::kWest);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(one(), two());
}

TEST(RandomStream, DependsOnSeedPurposeAndSide) {
  std::set<std::uint64_t> firsts;
  for (const std::uint64_t seed : {1, 2}) {
    for (const RandomPurpose purpose : {RandomPurpose::kCamera, RandomPurpose::kMotors}) {
      firsts.insert(RandomStream::of(seed, purpose)());
      for (const Side side : kSides) firsts.insert(RandomStream::of(seed, purpose, side)());
    }
  }
  EXPECT_EQ(firsts.size(), 12U);
}

TEST(RandomStream, UniformNumbersAreEvenlyDistributed) {
  RandomStream random(3);
  std::array<int, 10> counts{};
  for (int i = 0; i < 100000; ++i) ++counts[static_cast<std::size_t>(10 * random.uniform())];
  // Each count is binomial with mean 10000 and standard deviation 95; the tolerance is five of
  // these.
  for (const int count : counts) EXPECT_NEAR(count, 10000, 475);
}

TEST(RandomStream, NormalNumbersHaveMeanZeroAndDeviationOne) {
  RandomStream random(4);
  double sum = 0, squares = 0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0, 5 / 316.0);  // five standard errors
  EXPECT_NEAR(squares / kDraws, 1, 5 * 1.415 / 316.0);
}

}  // namespace
}  // namespace autoref
