// A round robin's results as CSV files and as text tables.
#pragma once

#include <string>
#include <vector>

#include "runner/analysis/standings.hpp"
#include "runner/io/table.hpp"

namespace autoref::runner {

// A matchup's row: its teams, summary_cells(), then team a's wins, draws and losses with their
// fractions.
Cells matchup_columns();
Cells matchup_cells(const Group& matchup);

// summary.csv: one row per matchup.
std::string matchups_csv(const std::vector<Group>& matchups);

// standings.csv: one row per team, best first, with games, goals, points (3 for a win, 1 for a
// draw), goal difference per game with its 95 % interval over all pairs, both ratings with
// intervals (-inf or inf for an open end), and the fractions of wins, draws and losses. Missing
// values are empty cells.
std::string standings_csv(const std::vector<Standing>& standings);

// The text tables; the first row is the header.
std::vector<Cells> matchups_rows(const std::vector<Group>& matchups);
std::vector<Cells> standings_rows(const std::vector<Standing>& standings);

// Alignment of their columns.
inline const std::vector<Align> kMatchupsColumns = {Align::kLeft, Align::kLeft};
inline const std::vector<Align> kStandingsColumns = {Align::kRight, Align::kLeft};

// The same as lines of text.
TextTable matchups_table(const std::vector<Group>& matchups);
TextTable standings_table(const std::vector<Standing>& standings);

}  // namespace autoref::runner
