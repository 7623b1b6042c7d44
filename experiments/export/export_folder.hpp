// A results folder as a SQLite database, for analyses in SQL, Python or R.
//
// Tables, with columns as in docs/schemas.md: `games` has a row per game, `settings` a row per
// setting, `events` a row per decision of the referee.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

struct ExportOptions {
  bool has_events = true;         // whether to write `events`; if not, no game is replayed
  int workers = 1;                // number of games played in parallel
  std::FILE* progress = nullptr;  // stream for progress lines; null: none are written
};

// The columns of those tables whose columns are the same for every folder.
std::vector<std::string> settings_columns();
std::vector<std::string> events_columns();

// Exports the folder and returns the path of the database file. Since results folders do not keep
// decisions, each game that is not void is replayed to get its events. Throws InputError if a game
// ends differently from its row, as can happen if another build played it, and Interrupted after
// Ctrl-C.
std::string exported(const ResultFolder& folder, const ExportOptions& options);

}  // namespace autoref::experiments
