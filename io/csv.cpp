#include "io/csv.hpp"

namespace autoref::io {
namespace {

std::string_view as_written(std::string_view line, bool is_first) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (is_first && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char letter : cell) {
    if (letter == '"') text += '"';
    text += letter == '\n' || letter == '\r' ? ' ' : letter;
  }
  return text + "\"";
}

// Removes one cell from the start of `rest`. Returns false if its quotes do not match.
bool take_cell(std::string_view& rest, std::string& cell) {
  cell.clear();
  if (!rest.starts_with('"')) {
    cell = rest.substr(0, rest.find(','));
    rest.remove_prefix(cell.size());
    return cell.find('"') == std::string::npos;
  }
  for (std::size_t i = 1; i < rest.size(); ++i) {
    // Two quotes inside a quoted cell stand for one (RFC 4180).
    if (rest[i] == '"') {
      if (i + 1 == rest.size() || rest[i + 1] != '"') {
        rest.remove_prefix(i + 1);
        return true;
      }
      ++i;
    }
    cell += rest[i];
  }
  return false;
}

}  // namespace

void append(Cells& cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

std::string csv_line(const Cells& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    line += quoted(cell);
  }
  return line;
}

std::optional<Cells> csv_cells(std::string_view line) {
  Cells cells;
  while (true) {
    std::string cell;
    if (!take_cell(line, cell)) return std::nullopt;
    cells.push_back(std::move(cell));
    if (line.empty()) return cells;
    if (line.front() != ',') return std::nullopt;
    line.remove_prefix(1);
  }
}

std::string first_cell(std::string_view line) {
  const std::optional<Cells> cells = csv_cells(line);
  return cells && !cells->empty() ? cells->front() : std::string();
}

std::vector<std::string_view> complete_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::vector<std::string_view> lines_as_written(std::string_view text) {
  std::vector<std::string_view> lines = complete_lines(text);
  bool is_first = true;
  for (std::string_view& line : lines) line = as_written(line, std::exchange(is_first, false));
  return lines;
}

void LinesAsWritten::add(std::string_view piece) {
  for (std::size_t end = piece.find('\n'); end != std::string_view::npos; end = piece.find('\n')) {
    const std::string_view line = piece.substr(0, end);
    piece.remove_prefix(end + 1);
    if (begun_.empty()) {
      pass_on(line);
    } else {
      pass_on(begun_.append(line));
      begun_.clear();
    }
  }
  begun_ += piece;
}

void LinesAsWritten::pass_on(std::string_view line) {
  take_(as_written(line, std::exchange(is_first_, false)));
}

}  // namespace autoref::io
