// Text tables, and text that fits a width.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace autoref::io {

enum class Align { kLeft, kRight };

// Width of text in files, pipes and reports, in characters. This width is the same on every
// machine.
inline constexpr std::size_t kTextWidth = 100;

// A table of text. All rows must have as many cells as the first row, which is the header.
struct TextTable {
  std::vector<std::vector<std::string>> rows;
  std::vector<Align> columns = {};  // right-aligned by default
  std::size_t keys = 1;             // number of leading columns that identify a row
};

// Tables and text, one below the other.
using TextBlocks = std::vector<std::variant<std::string, TextTable>>;

// Width of a UTF-8 text in characters.
std::size_t width_of(const std::string& text);

// Formats one line per row; lines can have any length. All rows must have as many cells as the
// first. A column is as wide as its widest cell; cells are right-aligned unless `columns` specifies
// otherwise.
std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<Align>& columns = {});

// Breaks lines that are longer than `width`, between words.
std::string wrapped(const std::string& text, std::size_t width);

// Formats the whole table in lines of at most `width` characters, provided that there is space for
// its key columns and one more column at 8 characters each. Tables of more than 2000 rows keep
// their width. If a table is too wide, its gaps become narrower first. Then cells are broken into
// several lines, between words but not within an interval in brackets. Finally, the columns that do
// not fit go into another table below, which repeats the `keys`.
std::string table_text(const TextTable& table, std::size_t width);

// The blocks as text, formatted by table_text() and wrapped().
std::string text_of(const TextBlocks& blocks, std::size_t width = kTextWidth);

// Removes a column if every cell below the header is "0".
TextTable without_zeros(TextTable table, std::size_t column);

}  // namespace autoref::io
