#include "view/base64.hpp"

#include <cstdint>

namespace autoref::view {
namespace {

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
