#include "runner/processes/live_view.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

TEST(BarText, IsFullWhenAllIsDone) {
  EXPECT_EQ(bar_text(0, 4), "[........................] ");
  EXPECT_EQ(bar_text(1, 4), "[######..................] ");
  EXPECT_EQ(bar_text(4, 4), "[########################] ");
}

TEST(LiveView, IsABarAloneWithoutATable) {
  EXPECT_EQ(live_view("the bar", "", {24, 80}), "\r\033[Jthe bar");
}

TEST(LiveView, LeavesTheCursorInTheBarsLine) {
  EXPECT_EQ(live_view("the bar", "one\n\nthree\n", {24, 80}),
            "\r\033[Jthe bar\none\n\nthree\r\033[3A");
}

TEST(LiveView, KeepsToTheScreensHeight) {
  const std::string view = live_view("the bar", "1\n2\n3\n4\n5\n6\n", {6, 80});
  EXPECT_EQ(view, "\r\033[Jthe bar\n1\n2\n3\n... 3 more lines\r\033[4A");
}

TEST(LiveView, KeepsToTheScreensWidth) {
  EXPECT_EQ(live_view("0123456789", "±±±±±±±±±±\n", {24, 6}), "\r\033[J01234\n±±±±±\r\033[1A");
}

TEST(LiveView, FitsTheSmallestScreen) {
  EXPECT_EQ(live_view("the bar", "1\n2\n", {1, 4}), "\r\033[Jthe");
}

}  // namespace
}  // namespace autoref::runner
