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
  std::size_t lines_below = 0;  // number of lines below the bar
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

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    widest = std::max(widest, width_of(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return widest;
}

void remove_column(ProgressTable& table, std::size_t column) {
  const auto at = static_cast<std::ptrdiff_t>(column);
  for (std::vector<std::string>& row : table.rows) row.erase(row.begin() + at);
  if (column < table.columns.size()) table.columns.erase(table.columns.begin() + at);
  std::erase(table.dispensable, column);
  for (std::size_t& other : table.dispensable) other -= other > column ? 1 : 0;
}

// Keeps as many columns as fit.
ProgressTable narrowed(ProgressTable table, int columns) {
  const auto most = static_cast<std::size_t>(std::max(1, columns - 1));
  while (table.rows.front().size() > 1 && widest_line(aligned(table.rows, table.columns)) > most) {
    const std::size_t last = table.rows.front().size() - 1;
    remove_column(table, table.dispensable.empty() ? last : table.dispensable.front());
  }
  return table;
}

int line_count(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

// Cuts the table to `lines` lines, at least two. Columns are as wide as for all rows, so they stay
// in position when rows change places.
std::string shortened(const ProgressTable& table, int lines) {
  std::string text = aligned(table.rows, table.columns);
  const auto most = static_cast<std::size_t>(lines);
  if (table.rows.size() <= most) return text;
  const std::size_t shown = most - 1;  // including the header
  std::size_t end = 0;
  for (std::size_t row = 0; row < shown; ++row) end = text.find('\n', end) + 1;
  return text.substr(0, end) +
         fmt::format("... {} more {}\n", table.rows.size() - shown, table.noun);
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

std::string fitted(const std::vector<ProgressTable>& tables, int lines, int columns) {
  constexpr int kLeastLines = 3;  // header, one row, and the number of remaining rows
  std::string text;
  for (const ProgressTable& table : tables) {
    const int gap = text.empty() ? 0 : 1;
    int room = lines - line_count(text) - gap;
    if (room < kLeastLines || table.rows.empty()) break;
    text.append(static_cast<std::size_t>(gap), '\n');
    const std::string lines_below =
        wrapped(table.text, static_cast<std::size_t>(std::max(1, columns - 1)));
    const int below = lines_below.empty() ? 0 : line_count(lines_below) + 1;
    const bool has_room_for_text = room - below >= kLeastLines;
    if (has_room_for_text) room -= below;
    text += shortened(narrowed(table, columns), room);
    if (has_room_for_text && below > 0) text += "\n" + lines_below;
  }
  return text;
}

}  // namespace autoref::io
