#include "soccer/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

namespace autoref {
namespace {

std::array<std::uint64_t, 100> numbers_for_key() {
  RandomStream stream = RandomStream::of(7, RandomPurpose::kKicker, Side::kWest);
  std::array<std::uint64_t, 100> numbers{};
  std::generate(numbers.begin(), numbers.end(), [&] { return stream(); });
  return numbers;
}

TEST(RandomStream, GivesTheSameNumbersForTheSameKey) {
  EXPECT_EQ(numbers_for_key(), numbers_for_key());
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

// How many of the uniform numbers are in each tenth of the range.
std::array<int, 10> counts_by_tenth(RandomStream random, int draws) {
  std::array<int, 10> counts{};
  for (int i = 0; i < draws; ++i) ++counts[static_cast<std::size_t>(10 * random.uniform())];
  return counts;
}

// Each count is binomial with mean 10000 and standard deviation 95; the tolerance is five of these.
TEST(RandomStream, UniformNumbersAreEvenlyDistributed) {
  const std::array<int, 10> counts = counts_by_tenth(RandomStream(3), 100000);
  EXPECT_GE(*std::min_element(counts.begin(), counts.end()), 10000 - 475);
  EXPECT_LE(*std::max_element(counts.begin(), counts.end()), 10000 + 475);
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

// docs/team-programs.md has this formula.
TEST(RandomStream, FollowsTheFormulaThatProgramsAreGiven) {
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;
  const auto mix = [](std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111eb;
    return x ^ (x >> 31U);
  };
  RandomStream stream(42);
  EXPECT_EQ(stream(), mix(mix(42 + kStep) + kStep));
  EXPECT_EQ(stream(), mix(mix(42 + kStep) + 2 * kStep));
}

}  // namespace
}  // namespace autoref
