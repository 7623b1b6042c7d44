#include "view/packed_column.hpp"

#include <gtest/gtest.h>

namespace autoref::view {
namespace {

// RFC 4648, section 10.
TEST(Base64, MatchesTheStandardsExamples) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

TEST(Base64, AcceptsAnyBytes) { EXPECT_EQ(base64_of("\xff\xfe\xfd"), "//79"); }

}  // namespace
}  // namespace autoref::view
