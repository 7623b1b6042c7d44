// The columns of a game's row, with functions to write and read each of them. To add a column, add
// an entry in columns.cpp and a member to the row's structs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/results/game_row.hpp"

namespace autoref::experiments {

struct Column {
  std::string name;
  std::function<std::string(const GameRow&)> text;
  // Returns false if the cell is not a valid value of the column.
  std::function<bool(const std::string& cell, GameRow& row)> read;
};

enum class RowKind : std::uint8_t {
  kPlayed,  // of a game: scores and counts
  kScene,   // of a scene: the same as for a game, and the scene's score
  kJudged,  // of a judged game: the referee's right and wrong calls
};

// Columns for what was played: the game's id, the factors' values, the teams and the seed. Before a
// row is read, its `values` must have the size of `factors`.
std::vector<Column> game_columns(const std::vector<std::string>& factors);

// Columns for the game's outcome and the hash of its configuration.
std::vector<Column> outcome_columns(RowKind kind);

// Columns of Circumstances.
std::vector<Column> circumstance_columns();

}  // namespace autoref::experiments
