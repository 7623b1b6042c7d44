#include "runner/io/json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace autoref::runner {
namespace {

std::string escaped(char letter) {
  switch (letter) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '\r':
      return "\\r";
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(letter);
  return code < 0x20 ? fmt::format("\\u{:04x}", code) : std::string(1, letter);
}

}  // namespace

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) quoted += escaped(letter);
  return quoted + "\"";
}

std::string json_number(double number) {
  return std::isfinite(number) ? fmt::format("{}", number) : "null";
}

std::string json_list(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

JsonObject& JsonObject::add(std::string_view key, std::string_view value) {
  members_ += fmt::format("{}{}: {}", members_.empty() ? "" : ", ", json_text(key), value);
  return *this;
}

}  // namespace autoref::runner
