#include "io/processes/standings_table.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>

namespace autoref::io {
namespace {

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

// Returns the first `columns` characters of a UTF-8 line, assuming one column per character.
std::string_view cut(std::string_view line, int columns) {
  int characters = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (begins_character(line[i]) && ++characters > columns) return line.substr(0, i);
  }
  return line;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

struct Drawn {
  std::string text;
  std::size_t lines_below = 0;  // below the bar
};

// Leaves the last column and the last row free: filling them could make the terminal scroll.
Drawn drawn(std::string_view bar, std::string_view table, const Screen& screen) {
  std::vector<std::string_view> lines = lines_of(table);
  const auto most = static_cast<std::size_t>(table_lines(screen));
  std::string more;
  if (lines.size() > most) {
    more = fmt::format("... {} more lines", lines.size() - most + 1);
    lines.resize(most);
    if (most > 0) lines.back() = more;
  }
  std::string view = fmt::format("{}{}", kClearTable, cut(bar, screen.columns - 1));
  for (const std::string_view line : lines)
    view += fmt::format("\n{}", cut(line, screen.columns - 1));
  return {view, lines.size()};
}

}  // namespace

Screen screen_of(std::FILE* stream) {
  winsize size{};
  if (ioctl(fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_row == 0 || size.ws_col == 0) {
    return {};
  }
  return {size.ws_row, size.ws_col};
}

int table_lines(const Screen& screen) { return std::max(0, screen.rows - 2); }

std::string bar_text(int done, int total, int width) {
  const int filled = total == 0 ? width : width * done / total;
  return fmt::format("[{:#<{}}{:.<{}}] ", "", filled, "", width - filled);
}

std::string bar_line(int done, int total, const std::string& text, int columns) {
  constexpr int kShortest = 4;
  constexpr int kFrame = 4;  // brackets, a space and the free column
  constexpr int kLongest = 24;
  const int width = std::min(kLongest, columns - kFrame - static_cast<int>(text.size()));
  return width < kShortest ? text : bar_text(done, total, width) + text;
}

std::string standings_table(std::string_view bar, std::string_view table, const Screen& screen) {
  const Drawn view = drawn(bar, table, screen);
  if (view.lines_below == 0) return view.text;
  // Moves the cursor back up to the bar, where the next drawing or message begins.
  return view.text + fmt::format("\r\033[{}A", view.lines_below);
}

std::string last_standings_table(std::string_view bar, std::string_view table,
                                 const Screen& screen) {
  return drawn(bar, table, screen).text + "\n";
}

}  // namespace autoref::io
