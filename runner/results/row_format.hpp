// A game's row as a line of a CSV file, the one text form that rows have.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/io/csv.hpp"
#include "runner/results/columns.hpp"
#include "runner/results/game_row.hpp"

namespace autoref::runner {

// The first column in which two rows of a game differ.
struct ColumnDifference {
  std::string column;
  std::string first;
  std::string second;
};

// The columns of an experiment's rows. A row holds first what is reproducible, then its
// circumstances, then `row_crc`, the CRC-32 of everything before it.
class RowFormat {
 public:
  // `factors` are the paths that head the columns of the factors' values.
  explicit RowFormat(const std::vector<std::string>& factors, RowKind kind = RowKind::kPlayed);

  // The names of all columns.
  Cells names() const;

  // The row as a line without its end. The row's values must be as many as the factors.
  std::string line(const GameRow& row) const;

  // Returns nullopt if the line is damaged: its checksum or the number of its cells is wrong, or a
  // cell does not hold what its column holds.
  std::optional<GameRow> read(std::string_view line) const;

  // The part of the columns, and of a row's cells, that results.csv keeps.
  Cells reproducible_names() const;
  Cells reproducible(const GameRow& row) const;

  // Compares the reproducible columns. Returns nullopt if they are all equal.
  std::optional<ColumnDifference> first_difference(const GameRow& first,
                                                   const GameRow& second) const;

 private:
  std::size_t factors_;
  std::vector<Column> columns_;  // all but row_crc
  std::size_t reproducible_ = 0;
};

}  // namespace autoref::runner
