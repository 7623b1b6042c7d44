// A game's row: which columns it has, and how a planned game and its record fill them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/experiments/schedule.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

using Cells = std::vector<std::string>;
using RowsById = std::map<std::string, Cells>;  // complete rows by their games
void append(Cells& cells, const Cells& more);

// What may differ from run to run.
struct Circumstances {
  std::string build;
  std::string host;
  std::string cpu;
  double wall_s = 0;
  int attempt = 1;
  std::string shard = "0/1";
};

// The columns of an experiment's games. A row holds first what a game always comes out with
// ("reproducible"), then its circumstances, then `row_crc` over all before it.
class RowFormat {
 public:
  // `factors` are the paths that head their columns, `outcome` what a game comes to.
  explicit RowFormat(const std::vector<std::string>& factors, const Cells& outcome);
  explicit RowFormat(const std::vector<std::string>& factors);  // outcome_columns()

  const Cells& columns() const { return columns_; }
  std::size_t column(std::string_view name) const;  // must exist
  std::size_t first_outcome() const { return first_outcome_; }

  // A finished row without its line end.
  std::string line(const ScheduledGame& game, const Cells& outcome,
                   const Circumstances& circumstances) const;

  // The cells of a line; none where it is damaged: row_crc or the number of cells do not fit, or
  // goals are not numbers.
  std::optional<Cells> read(std::string_view line) const;

  // The part of the cells that results.csv keeps.
  Cells reproducible(const Cells& cells) const;

 private:
  bool has_scores(const Cells& cells) const;

  Cells columns_;
  std::size_t first_outcome_ = 0;
  std::size_t reproducible_ = 0;
};

// The columns that follow from the record, goals_a to state_hash. `transitions` holds the labels of
// the transitions of the referee's machine that the game took, sorted and joined by '+'.
Cells outcome_columns();
Cells outcome_of(const GameRecord& record);

// The columns of a judged game: status, void_reason, state_hash and what its referee got right and
// wrong, as text (call_evaluation.hpp).
Cells evaluation_columns();

// The labels of the referee's transitions (referee/machine/machine.hpp) that none of the rows'
// games took, in the machine's order.
std::vector<std::string> transitions_never_used(const RowFormat& format,
                                                const std::vector<Cells>& rows);

}  // namespace autoref::runner
