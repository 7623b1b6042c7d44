#include "league/team/team_fault.hpp"

#include <fmt/format.h>

namespace autoref::league {

std::string excerpt_of(std::string_view bytes) {
  constexpr std::size_t kLongest = 40;
  std::string text = "\"";
  for (const char c : bytes.substr(0, kLongest)) {
    const bool is_printable = c >= ' ' && c <= '~' && c != '"' && c != '\\';
    text +=
        is_printable ? std::string(1, c) : fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
  }
  return text + (bytes.size() > kLongest ? "\"..." : "\"");
}

}  // namespace autoref::league
