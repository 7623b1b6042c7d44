#include "io/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "io/table.hpp"
#include "io/words.hpp"

namespace autoref::io {
namespace {

constexpr std::size_t kUsualWidth = 80;
constexpr std::size_t kNarrowestTerminal = 40;

std::optional<std::size_t> width_in_environment() {
  const char* const columns = std::getenv("COLUMNS");
  const std::optional<int> width = columns == nullptr ? std::nullopt : whole_number_in(columns);
  if (!width || *width <= 0) return std::nullopt;
  return static_cast<std::size_t>(*width);
}

std::size_t width_of_terminal(int descriptor) {
  winsize size{};
  const bool is_known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : kUsualWidth;
}

}  // namespace

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

std::size_t text_width(std::FILE* stream) {
  if (!is_terminal(stream)) return kTextWidth;
  const std::optional<std::size_t> given = width_in_environment();
  return std::max(kNarrowestTerminal, given ? *given : width_of_terminal(fileno(stream)));
}

}  // namespace autoref::io
