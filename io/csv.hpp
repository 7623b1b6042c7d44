// Comma-separated values as defined by RFC 4180, one row per line.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace autoref::io {

using Cells = std::vector<std::string>;
void append(Cells& cells, const Cells& more);

// Formats one row, without the line break. Cells with commas or quotes are quoted; line breaks in
// cells become spaces so that each row is a single line.
std::string csv_line(const Cells& cells);

// Returns the cells of one line, or nullopt if its quotes do not match.
std::optional<Cells> csv_cells(std::string_view line);

// Returns the first cell of a line; empty if its quotes do not match.
std::string first_cell(std::string_view line);

// Returns the complete lines of a text; anything after the last line break is dropped.
std::vector<std::string_view> complete_lines(std::string_view text);

// Like complete_lines(), for a file that an editor or a spreadsheet may have rewritten: removes a
// byte order mark and the carriage returns of lines that end in CR LF.
std::vector<std::string_view> lines_as_written(std::string_view text);

// Gives the lines of lines_as_written() for a text that arrives in pieces.
class LinesAsWritten {
 public:
  using TakeLine = std::function<void(std::string_view line)>;
  explicit LinesAsWritten(TakeLine take) : take_(std::move(take)) {}

  // Passes on the lines completed by this piece.
  void add(std::string_view piece);

 private:
  void pass_on(std::string_view line);

  TakeLine take_;
  std::string begun_;  // an incomplete line
  bool is_first_ = true;
};

}  // namespace autoref::io
