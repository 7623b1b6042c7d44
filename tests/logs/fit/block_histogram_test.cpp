#include "logs/fit/block_histogram.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

TEST(BlockHistogram, KnowsQuantiles) {
  RandomStream random(1);
  BlockHistogram histogram(10);
  for (int i = 0; i < 20'000; ++i) {
    if (i % 1000 == 0) histogram.start_block();
    histogram.add(5 * random.uniform());
  }
  const Estimate estimate = histogram.quantile(0.9);
  ASSERT_TRUE(estimate.number);
  EXPECT_EQ(estimate.episodes, 20'000);
  EXPECT_NEAR(estimate.number->value, 4.5, 0.03);
  EXPECT_LT(estimate.number->low, 4.5);
  EXPECT_GT(estimate.number->high, 4.5);
}

TEST(BlockHistogram, NeedsValuesAboveTheQuantile) {
  BlockHistogram histogram(10);
  for (int i = 0; i < 2000; ++i) {
    if (i % 100 == 0) histogram.start_block();
    histogram.add(1);
  }
  EXPECT_TRUE(histogram.quantile(0.98).number);
  EXPECT_FALSE(histogram.quantile(0.998).number);
}

TEST(BlockHistogram, NeedsSeveralBlocks) {
  BlockHistogram histogram(10);
  histogram.start_block();
  for (int i = 0; i < 2000; ++i) histogram.add(1);
  EXPECT_FALSE(histogram.quantile(0.5).number);
}

// Merging must not lose values, nor mix up which are frequent.
TEST(BlockHistogram, MergesBlocksOfLongRecordings) {
  BlockHistogram histogram(10);
  for (int block = 0; block < 5000; ++block) {
    histogram.start_block();
    histogram.add(block < 4000 ? 1.01 : 3.01);
    histogram.add(block < 4000 ? 1.01 : 3.01);
  }
  const Estimate estimate = histogram.quantile(0.79);
  EXPECT_EQ(estimate.episodes, 10'000);
  EXPECT_NEAR(estimate.number->value, 1.01, 0.02);
  EXPECT_NEAR(histogram.quantile(0.81).number->value, 3.01, 0.02);
}

TEST(BlockHistogram, CountsHugeValuesAsTheHighest) {
  BlockHistogram histogram(10);
  for (int block = 0; block < 20; ++block) {
    histogram.start_block();
    for (int i = 0; i < 10; ++i) histogram.add(1e30);
  }
  EXPECT_NEAR(histogram.quantile(0.5).number->value, 10, 0.02);
}

}  // namespace
}  // namespace autoref::logs
