// A game's row as a line of a CSV file, the only text form of rows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/results/columns.hpp"
#include "experiments/results/game_row.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {

// The first column in which two rows of a game differ.
struct ColumnDifference {
  std::string column;
  std::string first;
  std::string second;
};

// The columns of an experiment's rows: first the reproducible ones, then the circumstances, then
// `row_crc`, the CRC-32 of everything before it.
class RowFormat {
 public:
  // `factors` are the paths of the factors; the columns with the factors' values have these names.
  explicit RowFormat(const std::vector<std::string>& factors, RowKind kind = RowKind::kPlayed);

  // Names of all columns.
  io::Cells names() const;

  // The row as a line without a line break. It must have one value per factor.
  std::string line(const GameRow& row) const;

  // Returns nullopt if the line is damaged: that is, if its checksum or number of cells is wrong,
  // or if a cell is not a valid value of its column.
  std::optional<GameRow> read(std::string_view line) const;

  // Names of the columns in results.csv, and the cells of a row in these columns.
  io::Cells reproducible_names() const;
  io::Cells reproducible(const GameRow& row) const;

  // Compares two rows in the reproducible columns. Returns nullopt if they are all equal.
  std::optional<ColumnDifference> first_difference(const GameRow& first,
                                                   const GameRow& second) const;

 private:
  std::size_t factors_;
  std::vector<Column> columns_;  // all except row_crc
  std::size_t reproducible_ = 0;
};

}  // namespace autoref::experiments
