// Text tables, and text that fits a width.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace autoref::io {

enum class Align { kLeft, kRight };

// Width of text in files, pipes and reports, in characters: the same on every machine.
inline constexpr std::size_t kTextWidth = 100;

// All rows must have as many cells as the first, which is the head.
struct TextTable {
  std::vector<std::vector<std::string>> rows;
  std::vector<Align> columns = {};  // right where nothing is said
  std::size_t keys = 1;             // number of first columns that say what a row is about
};

// Tables and text, one below the other.
using TextBlocks = std::vector<std::variant<std::string, TextTable>>;

// Width of a UTF-8 text in characters.
std::size_t width_of(const std::string& text);

// Formats one line per row, however long. All rows must have as many cells as the first. A column
// is as wide as its widest cell; cells are right-aligned unless `columns` says otherwise.
std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<Align>& columns = {});

// Breaks lines that are longer than `width` between words.
std::string wrapped(const std::string& text, std::size_t width);

// Formats the table in lines of at most `width` characters, if that is room for its keys and
// another column of 8 each; everything is shown. Tables of more than 2000 rows keep their width. A
// table that is too wide gets narrower gaps, then cells of several lines, which are broken between
// words but not within an interval in brackets; finally, the columns that do not fit follow in
// another table below, which repeats the `keys`.
std::string table_text(const TextTable& table, std::size_t width);

// table_text() and wrapped() of the blocks.
std::string text_of(const TextBlocks& blocks, std::size_t width = kTextWidth);

// Removes a column in which every cell below the head is "0".
TextTable without_zeros(TextTable table, std::size_t column);

}  // namespace autoref::io
