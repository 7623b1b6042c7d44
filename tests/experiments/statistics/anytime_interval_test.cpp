#include "experiments/statistics/sequential_test.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "experiments/statistics/interval.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr int kLongest = 200;

std::vector<double> normal_values(std::uint64_t seed, double mean) {
  RandomStream random(seed);
  std::vector<double> values;
  values.reserve(kLongest);
  for (int i = 0; i < kLongest; ++i) values.push_back(mean + 2 * random.normal());
  return values;
}

using IntervalOf = std::optional<Interval> (*)(std::span<const double>);

// The proportion of experiments in which some interval along the way misses the mean.
double share_of_missing(IntervalOf interval_of) {
  constexpr int kExperiments = 400;
  int missing = 0;
  for (std::uint64_t seed = 1; seed <= kExperiments; ++seed) {
    const std::vector<double> values = normal_values(seed, 1);
    bool is_missed = false;
    for (std::size_t n = 2; n <= values.size() && !is_missed; ++n) {
      const auto interval = interval_of({values.data(), n});
      is_missed = interval && (interval->low > 1 || interval->high < 1);
    }
    missing += is_missed ? 1 : 0;
  }
  return static_cast<double>(missing) / kExperiments;
}

TEST(AnytimeInterval, ContainsTheMeanAtAllTimesInNinetyFivePercentOfExperiments) {
  EXPECT_LE(share_of_missing(anytime_interval), 0.05);
}

// Otherwise the test above would not show anything.
TEST(AnytimeInterval, IsNeededSinceStudentsMissesFarMoreOften) {
  EXPECT_GT(share_of_missing(mean_interval), 0.3);
}

TEST(AnytimeInterval, IsWiderThanStudentsButNotTwiceAsWide) {
  const std::vector<double> values = normal_values(1, 0);
  const Interval anytime = anytime_interval(values).value();
  const Interval student = mean_interval(values).value();
  const double ratio = (anytime.high - anytime.low) / (student.high - student.low);
  EXPECT_GT(ratio, 1.2);
  EXPECT_LT(ratio, 2);
}

TEST(AnytimeInterval, IsUnknownForFewOrEqualValues) {
  EXPECT_FALSE(anytime_interval(std::vector<double>{1}));
  EXPECT_FALSE(anytime_interval(std::vector<double>{1, 1, 1, 1}));
}

}  // namespace
}  // namespace autoref::experiments
