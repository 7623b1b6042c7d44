#include "view/packed_column.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace autoref::view {
namespace {

constexpr int kFarthestStep = 127;
constexpr char kWholeNumberFollows = static_cast<char>(-128);

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// Up to three bytes as one number; bytes beyond the end count as 0.
std::uint32_t three_bytes(std::string_view bytes, std::size_t begin) {
  std::uint32_t number = 0;
  for (std::size_t i = begin; i < begin + 3; ++i)
    number = number << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
  return number;
}

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

std::string base64_of(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t number = three_bytes(bytes, i);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += kLetters[number >> shift & 63U];
  }
  // Pads with '=' where the last group has no byte left.
  for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) text[text.size() - 1 - i] = '=';
  return text;
}

}  // namespace autoref::view
