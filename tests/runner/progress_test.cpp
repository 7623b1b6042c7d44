#include "runner/progress.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

TEST(DurationText, FitsTheLength) {
  EXPECT_EQ(duration_text(9.2), "9 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(3900), "1 h 05 min");
}

TEST(ProgressText, TellsSpeedAndTimeLeft) {
  // 10 games in 20 s: half a game a second; 60 are left.
  EXPECT_EQ(progress_text(60, 120, 10, 20), "60/120 games   30 games/min   2 min 00 s left");
}

TEST(ProgressText, TellsNoSpeedBeforeTheFirstGame) {
  EXPECT_EQ(progress_text(60, 120, 0, 20), "60/120 games");
}

}  // namespace
}  // namespace autoref::runner
