#include "experiments/results/row_format.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "io/checksum.hpp"

namespace autoref::experiments {
namespace {

void add_columns(std::vector<Column>& columns, std::vector<Column> more) {
  std::move(more.begin(), more.end(), std::back_inserter(columns));
}

}  // namespace

RowFormat::RowFormat(const std::vector<std::string>& factors, RowKind kind)
    : factors_(factors.size()), columns_(game_columns(factors)) {
  add_columns(columns_, outcome_columns(kind));
  reproducible_ = columns_.size();
  add_columns(columns_, circumstance_columns());
}

io::Cells RowFormat::names() const {
  io::Cells names;
  names.reserve(columns_.size() + 1);
  for (const Column& column : columns_) names.push_back(column.name);
  names.emplace_back("row_crc");
  return names;
}

std::string RowFormat::line(const GameRow& row) const {
  assert(row.values.size() == factors_);
  io::Cells cells;
  cells.reserve(columns_.size());
  for (const Column& column : columns_) cells.push_back(column.text(row));
  const std::string line = io::csv_line(cells);
  return line + "," + io::crc_text(line);
}

std::optional<GameRow> RowFormat::read(std::string_view line) const {
  const std::size_t comma = line.rfind(',');
  if (comma == std::string_view::npos) return std::nullopt;
  // The checksum detects rows that were torn or altered anywhere.
  if (line.substr(comma + 1) != io::crc_text(line.substr(0, comma))) return std::nullopt;
  const std::optional<io::Cells> cells = io::csv_cells(line.substr(0, comma));
  if (!cells || cells->size() != columns_.size()) return std::nullopt;
  GameRow row;
  row.values.resize(factors_);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!columns_[i].read((*cells)[i], row)) return std::nullopt;
  }
  return row;
}

io::Cells RowFormat::reproducible_names() const {
  io::Cells names = this->names();
  names.resize(reproducible_);
  return names;
}

io::Cells RowFormat::reproducible(const GameRow& row) const {
  io::Cells cells;
  cells.reserve(reproducible_);
  for (std::size_t i = 0; i < reproducible_; ++i) cells.push_back(columns_[i].text(row));
  return cells;
}

std::optional<ColumnDifference> RowFormat::first_difference(const GameRow& first,
                                                            const GameRow& second) const {
  for (std::size_t i = 0; i < reproducible_; ++i) {
    const std::string of_first = columns_[i].text(first);
    const std::string of_second = columns_[i].text(second);
    if (of_first != of_second) return ColumnDifference{columns_[i].name, of_first, of_second};
  }
  return std::nullopt;
}

}  // namespace autoref::experiments
