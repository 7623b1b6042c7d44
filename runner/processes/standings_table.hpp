// What a terminal shows of a run: a bar and tables of the games so far, drawn over by the next.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "runner/io/table.hpp"

namespace autoref::runner {

struct Screen {
  int rows = 24;
  int columns = 80;
};

// Of the terminal that the stream writes to; the usual size where it does not tell.
Screen screen_of(std::FILE* stream);

// A table; a small screen shows only part of it.
struct ProgressTable {
  std::vector<std::vector<std::string>> rows;  // the head, then the most important first
  std::vector<Align> columns = {};
  std::string noun = "rows";                  // what a row is, in the plural: "teams"
  std::vector<std::size_t> dispensable = {};  // columns that go first where there is no room
  std::string text = {};                      // lines below it, broken where they are too long
};

// As much of the tables as fits so many lines and columns, the most important table first. Columns
// that do not fit are left out, first the dispensable ones, then those at the right; rows that do
// not fit are counted in a last line, "... 12 more teams".
std::string fitted(const std::vector<ProgressTable>& tables, int lines, int columns);

// "[######......] " for `done` of `total`, with a bar of so many characters.
std::string bar_text(int done, int total, int width = 24);

// The same before `text`, with a bar as long as there is room for in one line of so many columns;
// `text` alone where there is none.
std::string bar_line(int done, int total, const std::string& text, int columns);

// Makes the line that the cursor is in, and all below it, empty.
inline constexpr std::string_view kClearTable = "\r\033[J";

// Draws `bar` and below it `table`, whose lines may be none, where the cursor is; leaves the cursor
// in the bar's line, for kClearTable or the next view. What does not fit the screen is cut off.
std::string standings_table(std::string_view bar, std::string_view table, const Screen& screen);

// The same to stay on the screen: the cursor ends in the line below.
std::string last_standings_table(std::string_view bar, std::string_view table,
                                 const Screen& screen);

// How many lines there are below the bar.
int table_lines(const Screen& screen);

}  // namespace autoref::runner
