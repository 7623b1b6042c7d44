#include "experiments/analysis/groups.hpp"

#include <gtest/gtest.h>

namespace autoref::experiments {
namespace {

const io::TableColumns<ResultCounts> kCounts = {
    {"wins", [](const ResultCounts& counts) { return counts[0]; }},
    {"draws", [](const ResultCounts& counts) { return counts[1]; }},
    {"losses", [](const ResultCounts& counts) { return counts[2]; }}};

std::string shares_csv(const ResultCounts& counts) {
  return io::csv_line(io::cells_of(share_columns(kCounts), counts));
}

TEST(ResultShares, AreNamedAfterTheirCounts) {
  EXPECT_EQ(io::csv_line(io::heads_of(share_columns(kCounts))),
            "wins_share,wins_low95,wins_high95,draws_share,draws_low95,draws_high95,losses_share,"
            "losses_low95,losses_high95");
}

// Wilson intervals for 8 and 12 of 20, computed from the formula in Python; the Clopper-Pearson
// interval for 0 of 20 ends at 1 - 0.025^(1/20) = 0.1684.
TEST(ResultShares, HaveTheIntervalsOfTheirCounts) {
  EXPECT_EQ(shares_csv({8, 0, 12}),
            "0.4000,0.2188,0.6134,0.0000,0.0000,0.1684,0.6000,0.3866,0.7812");
}

TEST(ResultShares, AreEmptyWithoutGames) {
  EXPECT_EQ(shares_csv({0, 0, 0}), ",,,,,,,,");
  EXPECT_EQ(share_text(0, 0), "-");
}

TEST(ResultShares, ArePrintedInPercent) { EXPECT_EQ(share_text(8, 20), "40 % [22, 61]"); }

}  // namespace
}  // namespace autoref::experiments
