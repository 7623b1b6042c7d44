#include "view/packed_column.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::view {
namespace {

constexpr int kFarthestStep = 127;
constexpr char kWholeNumberFollows = static_cast<char>(-128);

}  // namespace

void PackedColumn::add(std::int16_t number) {
  const int step = number - last_;
  last_ = number;
  if (std::abs(step) <= kFarthestStep) {
    bytes_ += static_cast<char>(step);
    return;
  }
  const auto bits = static_cast<std::uint16_t>(number);
  bytes_ += kWholeNumberFollows;
  bytes_ += static_cast<char>(bits & 0xffU);
  bytes_ += static_cast<char>(bits >> 8U);
}

std::int16_t packed(double number) {
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(number, -kMost, kMost)));
}

}  // namespace autoref::view
