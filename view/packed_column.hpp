// Compresses a sequence of integers with small differences, and encodes bytes as Base64.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace autoref::view {

// Stores each number as one byte: its difference from the previous number (initially kNothing) as
// int8. If the difference is outside -127 to 127, stores -128 followed by the number as a
// little-endian int16.
class PackedColumn {
 public:
  // The value for "not seen".
  static constexpr std::int16_t kNothing = std::numeric_limits<std::int16_t>::min();

  void add(std::int16_t number);
  // Starts the column with `count` copies of kNothing. It must be empty.
  void begin_with_nothing(std::size_t count) { bytes_.assign(count, '\0'); }

  const std::string& bytes() const { return bytes_; }

 private:
  std::int16_t last_ = kNothing;
  std::string bytes_;
};

// The nearest number that a column can store, other than kNothing.
std::int16_t packed(double number);

// Base64 encoding (RFC 4648, section 4).
std::string base64_of(std::string_view bytes);

}  // namespace autoref::view
