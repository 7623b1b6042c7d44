#include "view/packed_column.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <vector>

namespace autoref::view {
namespace {

using namespace std::string_literals;

std::string packed_bytes(std::initializer_list<int> numbers) {
  PackedColumn column;
  for (const int number : numbers) column.add(static_cast<std::int16_t>(number));
  return column.bytes();
}

TEST(PackedColumn, UsesOneByteForASmallStep) {
  EXPECT_EQ(packed_bytes({-32767, -32640, -32767}), "\x01\x7f\x81"s);
}

TEST(PackedColumn, StoresTheNumberItselfForALargeStep) {
  EXPECT_EQ(packed_bytes({0, 128, 0x1234}), "\x80\x00\x00\x80\x80\x00\x80\x34\x12"s);
}

TEST(PackedColumn, StoresNothing) {
  PackedColumn column;
  column.begin_with_nothing(2);
  column.add(-3);
  column.add(PackedColumn::kNothing);
  EXPECT_EQ(column.bytes(), "\0\0\x80\xfd\xff\x80\x00\x80"s);
}

TEST(PackedColumn, StoresTheNearestNumberOtherThanNothing) {
  EXPECT_EQ(packed(12.5), 13);
  EXPECT_EQ(packed(-1e30), -32767);
  EXPECT_EQ(packed(std::numeric_limits<double>::infinity()), 32767);
}

}  // namespace
}  // namespace autoref::view
