// What is told of a round robin: rows for programs, tables for people.
#pragma once

#include <string>
#include <vector>

#include "runner/analysis/standings.hpp"
#include "runner/io/table.hpp"

namespace autoref::runner {

// A matchup's row: what summary_cells() says of it, then team a's wins, draws and losses with
// their shares.
Cells matchup_columns();
Cells matchup_cells(const Group& matchup);

// summary.csv: a row per matchup.
std::string matchups_csv(const std::vector<Group>& matchups);

// standings.csv: per team, best first, its games, goals, points (3 for a win, 1 for a draw), and
// the goal difference per game with its 95 % interval over all its pairs, and its two ratings with
// intervals from resampled pairs, and the shares of its wins, draws and losses. Cells without a
// value are empty.
std::string standings_csv(const std::vector<Standing>& standings);

// The tables for people, the head first.
std::vector<Cells> matchups_rows(const std::vector<Group>& matchups);
std::vector<Cells> standings_rows(const std::vector<Standing>& standings);

// How their columns are aligned.
inline const std::vector<Align> kMatchupsColumns = {Align::kLeft, Align::kLeft};
inline const std::vector<Align> kStandingsColumns = {Align::kRight, Align::kLeft};

// The same as text, several lines each.
std::string matchups_table(const std::vector<Group>& matchups);
std::string standings_table(const std::vector<Standing>& standings);

}  // namespace autoref::runner
