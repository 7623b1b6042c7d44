// A knockout's results as a CSV file and as a table.
#pragma once

#include <string>
#include <vector>

#include "runner/analysis/played_bracket.hpp"
#include "runner/io/table.hpp"

namespace autoref::runner {

// summary.csv: a row per tie with its teams, the score of its last game that is not void, its
// shoot-out, how many games it took, how many of them were void, what decided it and who goes on.
// Cells of what is not known yet are empty.
std::string ties_csv(const std::vector<Tie>& ties, const RowsById& rows);

// The ties with their scores, the head first.
std::vector<Cells> bracket_rows(const std::vector<Tie>& ties, const RowsById& rows);
inline const std::vector<Align> kBracketColumns = {Align::kLeft, Align::kRight, Align::kLeft,
                                                   Align::kLeft, Align::kLeft,  Align::kLeft};

// The same as text, then the winner; several lines.
std::string bracket_table(const std::vector<Tie>& ties, const RowsById& rows);

}  // namespace autoref::runner
