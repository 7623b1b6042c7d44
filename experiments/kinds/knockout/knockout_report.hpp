// A knockout's results as a CSV file and as a text table.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/knockout/bracket.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// summary.csv: one row per tie with its teams, the score and shoot-out of its last game that is not
// void, the numbers of games and of void games, how it was decided and the winner. Cells that are
// not known yet are empty.
std::string ties_csv(const std::vector<Tie>& ties, const RowsById& rows);

// The ties with their scores; the first row is the header.
std::vector<io::Cells> bracket_rows(const std::vector<Tie>& ties, const RowsById& rows);
inline const std::vector<io::Align> kBracketColumns = {io::Align::kLeft, io::Align::kRight,
                                                       io::Align::kLeft, io::Align::kLeft,
                                                       io::Align::kLeft, io::Align::kLeft};

// The ties in the same order, with all that is known about them.
std::vector<TieResult> tie_results(const std::vector<Tie>& ties, const RowsById& rows);

// [{"tie": "final", "team_a": "cobalt", "team_b": null, "games": 1, "decided_by": "goals",
//   "winner": "cobalt"}, ...]; unknown teams and winners are null.
io::Json json_of(const std::vector<Tie>& ties);

// The same as lines of text, followed by the winner.
io::TextBlocks bracket_table(const std::vector<Tie>& ties, const RowsById& rows);

}  // namespace autoref::experiments
