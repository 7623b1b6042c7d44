#include "runner/processes/standings_table.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

TEST(BarText, IsFullWhenAllIsDone) {
  EXPECT_EQ(bar_text(0, 4), "[........................] ");
  EXPECT_EQ(bar_text(1, 4), "[######..................] ");
  EXPECT_EQ(bar_text(4, 4), "[########################] ");
}

TEST(StandingsTable, IsABarAloneWithoutATable) {
  EXPECT_EQ(standings_table("the bar", "", {24, 80}), "\r\033[Jthe bar");
}

TEST(StandingsTable, LeavesTheCursorInTheBarsLine) {
  EXPECT_EQ(standings_table("the bar", "one\n\nthree\n", {24, 80}),
            "\r\033[Jthe bar\none\n\nthree\r\033[3A");
}

TEST(StandingsTable, KeepsToTheScreensHeight) {
  const std::string view = standings_table("the bar", "1\n2\n3\n4\n5\n6\n", {6, 80});
  EXPECT_EQ(view, "\r\033[Jthe bar\n1\n2\n3\n... 3 more lines\r\033[4A");
}

TEST(StandingsTable, KeepsToTheScreensWidth) {
  EXPECT_EQ(standings_table("0123456789", "±±±±±±±±±±\n", {24, 6}),
            "\r\033[J01234\n±±±±±\r\033[1A");
}

TEST(StandingsTable, FitsTheSmallestScreen) {
  EXPECT_EQ(standings_table("the bar", "1\n2\n", {1, 4}), "\r\033[Jthe");
}

}  // namespace
}  // namespace autoref::runner
