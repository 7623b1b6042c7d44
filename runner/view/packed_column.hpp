// Many small whole numbers that change little from one to the next, in few bytes.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace autoref::runner {

// Each number is one byte, its difference from the one before (the first from kNothing) as int8.
// Where that does not fit into -127 to 127 there stands -128 instead, and then the number itself as
// int16, the lower byte first.
class PackedColumn {
 public:
  // Stands for "not seen".
  static constexpr std::int16_t kNothing = std::numeric_limits<std::int16_t>::min();

  void add(std::int16_t number);
  // Begins with `count` times kNothing; nothing may have been added before.
  void begin_with_nothing(std::size_t count) { bytes_.assign(count, '\0'); }

  const std::string& bytes() const { return bytes_; }

 private:
  std::int16_t last_ = kNothing;
  std::string bytes_;
};

// The nearest number that a column can hold and that is not kNothing.
std::int16_t packed(double number);

}  // namespace autoref::runner
