// Fits tables to a screen. Declared in standings_table.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "io/processes/standings_table.hpp"

namespace autoref::io {
namespace {

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
  const std::size_t shown = most - 1;  // including the head
  std::size_t end = 0;
  for (std::size_t row = 0; row < shown; ++row) end = text.find('\n', end) + 1;
  return text.substr(0, end) +
         fmt::format("... {} more {}\n", table.rows.size() - shown, table.noun);
}

}  // namespace

std::string fitted(const std::vector<ProgressTable>& tables, int lines, int columns) {
  constexpr int kLeastLines = 3;  // head, one row, and the number of remaining rows
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
