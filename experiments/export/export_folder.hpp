// A results folder as a SQLite database, for analyses in SQL, Python or R.
//
// Tables, with columns as in docs/schemas.md: `games` has a row per game, `settings` a row per
// setting, and game_tables.hpp has the others.
#pragma once

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "experiments/export/sqlite_file.hpp"
#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

struct ReplayOptions {
  int workers = 1;                // number of games played in parallel
  std::FILE* progress = nullptr;  // stream for progress lines; null: none are written
  std::string remedy = {};        // what else to do if a game cannot be repeated, for the message
};

// The columns of `settings`, and of a table in game_tables(). Throws std::logic_error if that
// table's name is unknown.
std::vector<std::string> settings_columns();
std::vector<std::string> game_table_columns(const std::string& name);

// Replays some of the folder's good games, given by their positions in `folder.games`, and adds to
// the database what results folders do not keep (game_tables.hpp). Throws InputError if a game ends
// differently from its row, as can happen if another build played it, and Interrupted after Ctrl-C.
void add_game_tables(SqliteFile& file, const ResultFolder& folder,
                     const std::vector<std::size_t>& games, const ReplayOptions& options);

// Exports the folder and returns the content of the database file. Without `replays`, the tables
// that take a replay are left out. Throws like add_game_tables().
std::string exported(const ResultFolder& folder, const std::optional<ReplayOptions>& replays);

}  // namespace autoref::experiments
