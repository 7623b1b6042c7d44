// The terminal view of a run: a progress bar and tables of the games so far, redrawn in place.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "io/table.hpp"

namespace autoref::io {

struct Screen {
  int rows = 24;
  int columns = 80;
};

// Size of the terminal to which the stream writes; a default size if unknown.
Screen screen_of(std::FILE* stream);

// A table that can be shortened for small screens.
struct ProgressTable {
  // The header, then the other rows by decreasing importance.
  std::vector<std::vector<std::string>> rows;
  std::vector<Align> columns = {};
  std::string noun = "rows";                  // plural noun for what a row describes: "teams"
  std::vector<std::size_t> dispensable = {};  // columns to drop first if space is short
  std::string text = {};                      // text below the table, wrapped if too long
};

// Fits the tables into this many lines and columns, starting with the most important table. Drops
// columns that do not fit, first the dispensable ones, then the rightmost ones. If rows are left
// out, the last line counts them: "... 12 more teams".
std::string fitted(const std::vector<ProgressTable>& tables, int lines, int columns);

// "[######......] " for `done` of `total`, with a bar of `width` characters.
std::string bar_text(int done, int total, int width = 24);

// The bar followed by `text` in one line of `columns` columns, where the bar is as long as space
// allows. Returns only `text` if there is no space for a bar.
std::string bar_line(int done, int total, const std::string& text, int columns);

// Clears the cursor's line and everything below it.
inline constexpr std::string_view kClearTable = "\r\033[J";

// Draws `bar` at the cursor and `table` (possibly empty) below it, and leaves the cursor on the
// bar's line, for kClearTable or the next view. Cuts off whatever does not fit on the screen.
std::string standings_table(std::string_view bar, std::string_view table, const Screen& screen);

// Like standings_table(), but for a final view: the cursor ends on the line below it.
std::string last_standings_table(std::string_view bar, std::string_view table,
                                 const Screen& screen);

// Number of lines available below the bar.
int table_lines(const Screen& screen);

}  // namespace autoref::io
