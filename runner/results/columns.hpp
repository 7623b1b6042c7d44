// The columns of a game's row: how each is written and read. A new column is an entry here beside
// its member in the row's structs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "runner/results/game_row.hpp"

namespace autoref::runner {

struct Column {
  std::string name;
  std::function<std::string(const GameRow&)> text;
  // Returns false if the cell does not hold what the column holds.
  std::function<bool(const std::string& cell, GameRow& row)> read;
};

enum class RowKind : std::uint8_t {
  kPlayed,  // scores and counts
  kJudged,  // what the referee got right and wrong
};

// What was played: the game's name, the factors' values, the teams, the seed. A row that is read
// must have room for the values.
std::vector<Column> game_columns(const std::vector<std::string>& factors);

// How it ended, and the hash of its configuration.
std::vector<Column> outcome_columns(RowKind kind);

// The circumstances.
std::vector<Column> circumstance_columns();

}  // namespace autoref::runner
