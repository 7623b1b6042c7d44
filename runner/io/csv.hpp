// Comma-separated values as RFC 4180 has them, one row a line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::runner {

using Cells = std::vector<std::string>;
void append(Cells& cells, const Cells& more);

// One line without its end. Cells with commas or quotes are quoted; line ends in cells become
// spaces, so that a row is a line.
std::string csv_line(const Cells& cells);

// The cells of one line; none where its quotes do not match.
std::optional<Cells> csv_cells(std::string_view line);

// The complete lines of a text: what follows the last line end is left out.
std::vector<std::string_view> complete_lines(std::string_view text);

}  // namespace autoref::runner
