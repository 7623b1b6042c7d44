#include "runner/io/table.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

TEST(Table, AlignsCellsRightByDefault) {
  EXPECT_EQ(aligned({{"a", "x"}, {"bcd", "100"}}, {Align::kLeft}), "a       x\nbcd   100\n");
}

TEST(Table, CountsLettersNotBytes) { EXPECT_EQ(aligned({{"±"}, {"ab"}}), " ±\nab\n"); }

TEST(Table, LeavesNoSpaceAtTheEndsOfLines) {
  EXPECT_EQ(aligned({{"a", "b"}, {"c", "long"}}, {Align::kLeft, Align::kLeft}),
            "a   b\nc   long\n");
}

}  // namespace
}  // namespace autoref::runner
