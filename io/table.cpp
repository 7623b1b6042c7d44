#include "io/table.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace autoref::io {
namespace {

constexpr std::size_t kGap = 3;            // spaces between columns
constexpr std::size_t kNarrowGap = 2;      // spaces between columns if the table is too wide
constexpr std::size_t kMostFitted = 2000;  // number of rows; longer tables keep their width
constexpr std::size_t kNarrowestCell = 8;  // words are not broken into shorter pieces

using TextRows = std::vector<std::vector<std::string>>;

// Where cells may be broken. Each value includes the ones before it.
enum class Breaks { kBetweenWords, kBeforeDeviations, kWithinWords };

// In UTF-8, bytes of the form 10xxxxxx continue a character.
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether the space at `i` belongs to a number: before a percent sign, a unit or a deviation, or
// after a plus-minus sign.
bool binds(std::string_view text, std::size_t i, Breaks breaks) {
  const std::string_view next = text.substr(i + 1);
  const bool has_unit = i > 0 && is_digit(text[i - 1]) &&
                        (next == "s" || next == "m" || next == "m/s" || next.starts_with("s "));
  const bool has_deviation = breaks == Breaks::kBetweenWords && next.starts_with("±");
  return has_unit || has_deviation || next.starts_with("%") || text.substr(0, i).ends_with("±");
}

// Breaks one line at spaces outside of brackets; longer words are kept unless they may be broken.
std::vector<std::string> broken(std::string_view text, std::size_t width, Breaks breaks) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  std::size_t space = std::string::npos;  // the last space in the line that may become a break
  std::size_t count = 0;                  // number of characters in the line
  int depth = 0;
  bool has_word = false;  // whether the line has a word; spaces before it are indentation
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (continues_character(text[i])) continue;
    depth += (text[i] == '[' ? 1 : 0) - (text[i] == ']' ? 1 : 0);
    if (text[i] != ' ') has_word = true;
    if (text[i] == ' ' && has_word && depth <= 0 && !binds(text, i, breaks)) space = i;
    if (++count <= width) continue;
    const bool is_cut = space == std::string::npos && breaks == Breaks::kWithinWords;
    if (space == std::string::npos && !is_cut) continue;
    lines.emplace_back(text.substr(begin, (is_cut ? i : space) - begin));
    begin = is_cut ? i : space + 1;
    count = begin > i ? 0 : width_of(std::string(text.substr(begin, i - begin))) + 1;
    space = std::string::npos;
    has_word = begin <= i && text[i] != ' ';
  }
  lines.emplace_back(text.substr(begin));
  return lines;
}

std::size_t widest_of(const std::vector<std::string>& lines) {
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, width_of(line));
  return widest;
}

std::vector<std::size_t> widths_of(const TextRows& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  return widths;
}

std::size_t total_of(const std::vector<std::size_t>& widths, std::size_t gap) {
  return std::accumulate(widths.begin(), widths.end(), gap * (widths.size() - 1));
}

// How the columns are written.
struct ColumnLayout {
  std::vector<std::size_t> widths;
  std::size_t gap = kGap;
  Breaks breaks = Breaks::kBetweenWords;
};

// Formats one line of cells that fit their columns.
std::string line_in_columns(const std::vector<std::string>& cells,
                            const std::vector<Align>& columns, const ColumnLayout& layout) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_left = i < columns.size() && columns[i] == Align::kLeft;
    const std::string space(layout.widths[i] - std::min(layout.widths[i], width_of(cells[i])), ' ');
    if (i > 0) line.append(layout.gap, ' ');
    line += is_left ? cells[i] + space : space + cells[i];
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

bool fits_in_columns(const std::vector<std::string>& row, const ColumnLayout& layout) {
  for (std::size_t i = 0; i < row.size(); ++i)
    if (width_of(row[i]) > layout.widths[i]) return false;
  return true;
}

// Formats one row, with as many lines as its tallest cell.
std::string row_in_columns(const std::vector<std::string>& row, const std::vector<Align>& columns,
                           const ColumnLayout& layout) {
  if (fits_in_columns(row, layout)) return line_in_columns(row, columns, layout);
  std::vector<std::vector<std::string>> lines;  // the lines of each cell
  for (std::size_t i = 0; i < row.size(); ++i) {
    std::vector<std::string> parts = broken(row[i], layout.widths[i], layout.breaks);
    if (lines.size() < parts.size())
      lines.resize(parts.size(), std::vector<std::string>(row.size()));
    for (std::size_t n = 0; n < parts.size(); ++n) lines[n][i] = std::move(parts[n]);
  }
  std::string text;
  for (const std::vector<std::string>& cells : lines)
    text += line_in_columns(cells, columns, layout);
  return text;
}

std::string rows_in_columns(const TextTable& table, const ColumnLayout& layout) {
  std::string text;
  for (const std::vector<std::string>& row : table.rows)
    text += row_in_columns(row, table.columns, layout);
  return text;
}

// The next smaller width of a column at which some cell needs more lines.
std::size_t narrower(const TextRows& rows, std::size_t column, std::size_t width, Breaks breaks) {
  std::size_t widest = 0;
  for (const std::vector<std::string>& row : rows) {
    if (width_of(row[column]) <= widest) continue;
    widest = std::max(widest, widest_of(broken(row[column], width - 1, breaks)));
  }
  return std::min(widest, width);
}

// Chooses the columns with cells to break, so that the table fits and has as few lines as possible.
class ColumnFitter {
 public:
  ColumnFitter(const TextRows& rows, Breaks breaks)
      : rows_(rows), breaks_(breaks), widths_(widths_of(rows)), heights_(rows.size(), 1) {}

  // Returns whether the columns now fit.
  bool fit(std::size_t width) {
    while (total_of(widths_, kNarrowGap) > width) {
      if (!narrow_one()) return false;
    }
    return true;
  }
  const std::vector<std::size_t>& widths() const { return widths_; }

 private:
  // Narrows the column that costs the fewest lines per character. Each call makes some column
  // narrower, so the number of calls is limited.
  bool narrow_one() {
    std::size_t best = widths_.size();
    std::size_t best_width = 0;
    double best_cost = 0;
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      const std::size_t width = widths_[i] == 0 ? 0 : narrower(rows_, i, widths_[i], breaks_);
      if (width >= widths_[i]) continue;
      const double cost =
          static_cast<double>(more_lines(i, width)) / static_cast<double>(widths_[i] - width);
      if (best < widths_.size() && cost >= best_cost) continue;
      best = i;
      best_width = width;
      best_cost = cost;
    }
    if (best == widths_.size()) return false;
    widths_[best] = best_width;
    for (std::size_t row = 0; row < rows_.size(); ++row)
      heights_[row] = std::max(heights_[row], height_of(row, best, best_width));
    return true;
  }

  std::size_t height_of(std::size_t row, std::size_t column, std::size_t width) const {
    const std::string& cell = rows_[row][column];
    return width_of(cell) <= width ? 1 : broken(cell, width, breaks_).size();
  }

  std::size_t more_lines(std::size_t column, std::size_t width) const {
    std::size_t more = 0;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      const std::size_t height = height_of(row, column, width);
      more += height > heights_[row] ? height - heights_[row] : 0;
    }
    return more;
  }

  const TextRows& rows_;
  Breaks breaks_;
  std::vector<std::size_t> widths_;
  std::vector<std::size_t> heights_;  // heights of the rows, in lines
};

// The keys and the columns from `begin` to `end`.
TextTable columns_between(const TextTable& table, std::size_t keys, std::size_t begin,
                          std::size_t end) {
  TextTable part{{}, {}, keys};
  const auto is_in = [&](std::size_t i) { return i < keys || (i >= begin && i < end); };
  for (const std::vector<std::string>& row : table.rows) {
    part.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i)
      if (is_in(i)) part.rows.back().push_back(row[i]);
  }
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (is_in(i)) part.columns.push_back(table.columns[i]);
  return part;
}

// Breaks even words, in the widest columns first.
std::string with_broken_words(const TextTable& table, std::vector<std::size_t> widths,
                              std::size_t width) {
  while (total_of(widths, kNarrowGap) > width) {
    const auto widest = std::max_element(widths.begin(), widths.end());
    if (*widest <= kNarrowestCell) break;
    --*widest;
  }
  return rows_in_columns(table, {std::move(widths), kNarrowGap, Breaks::kWithinWords});
}

// The largest number of leading columns that fit.
std::size_t fitting_columns(const TextTable& table, std::size_t keys, std::size_t width) {
  std::size_t count = table.rows.front().size() - 1;
  const auto fits = [&](std::size_t columns) {
    const TextTable part = columns_between(table, 0, 0, columns);
    return ColumnFitter(part.rows, Breaks::kBeforeDeviations).fit(width);
  };
  while (count > keys + 1 && !fits(count)) --count;
  return count;
}

}  // namespace

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<Align>& columns) {
  return rows_in_columns({rows, columns}, {widths_of(rows), kGap});
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    const std::vector<std::string> parts = broken(line, width, Breaks::kBeforeDeviations);
    for (std::size_t i = 0; i < parts.size(); ++i) lines += (i > 0 ? "\n" : "") + parts[i];
    if (end < text.size()) lines += '\n';
    begin = end + 1;
  }
  return lines;
}

std::string table_text(const TextTable& table, std::size_t width) {
  if (table.rows.empty()) return {};
  std::vector<std::size_t> natural = widths_of(table.rows);
  if (total_of(natural, kGap) <= width || table.rows.size() > kMostFitted)
    return rows_in_columns(table, {std::move(natural)});
  for (const Breaks breaks : {Breaks::kBetweenWords, Breaks::kBeforeDeviations}) {
    ColumnFitter fitter(table.rows, breaks);
    if (fitter.fit(width)) return rows_in_columns(table, {fitter.widths(), kNarrowGap, breaks});
  }
  const std::size_t columns = natural.size();
  const std::size_t keys = std::min(table.keys, columns - 1);
  if (columns <= keys + 1) return with_broken_words(table, std::move(natural), width);
  const std::size_t count = fitting_columns(table, keys, width);
  return table_text(columns_between(table, keys, 0, count), width) + "\n" +
         table_text(columns_between(table, keys, count, columns), width);
}

std::string text_of(const TextBlocks& blocks, std::size_t width) {
  std::string text;
  for (const auto& block : blocks) {
    const auto* table = std::get_if<TextTable>(&block);
    text +=
        table != nullptr ? table_text(*table, width) : wrapped(std::get<std::string>(block), width);
  }
  return text;
}

TextTable without_zeros(TextTable table, std::size_t column) {
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    if (table.rows[i][column] != "0") return table;
  const auto at = static_cast<std::ptrdiff_t>(column);
  for (std::vector<std::string>& row : table.rows) row.erase(row.begin() + at);
  if (column < table.columns.size()) table.columns.erase(table.columns.begin() + at);
  return table;
}

}  // namespace autoref::io
