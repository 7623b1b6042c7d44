// A knockout's results as a CSV file and as a text table.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/knockout/bracket.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// summary.csv: one row per tie with its teams, the score and shoot-out of the last game that is not
// void, the number of games, the number of void games, how the tie was decided, and its winner.
// Cells with values that are not known yet are empty.
std::string ties_csv(const std::vector<Tie>& ties, const RowsById& rows);

// The table of ties with their scores; its first row is the header.
std::vector<io::Cells> bracket_rows(const std::vector<Tie>& ties, const RowsById& rows);
inline const std::vector<io::Align> kBracketColumns = {io::Align::kLeft, io::Align::kRight,
                                                       io::Align::kLeft, io::Align::kLeft,
                                                       io::Align::kLeft, io::Align::kLeft};

// The results of the ties so far, in the order of `ties`.
std::vector<TieResult> tie_results(const std::vector<Tie>& ties, const RowsById& rows);

// [{"tie": "final", "team_a": "cobalt", "team_b": null, "games": 1, "decided_by": "goals",
//   "winner": "cobalt"}, ...]; unknown teams and winners are null.
io::Json json_of(const std::vector<Tie>& ties);

// The table of ties as lines of text, followed by the winner of the knockout.
io::TextBlocks bracket_table(const std::vector<Tie>& ties, const RowsById& rows);

}  // namespace autoref::experiments
