// A knockout's results as a CSV file and as a text table.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "runner/analysis/played_bracket.hpp"
#include "runner/io/csv.hpp"
#include "runner/io/table.hpp"

namespace autoref::runner {

// summary.csv: one row per tie with its teams, the score and shoot-out of its last game that is not
// void, its number of games, how many of them were void, what decided it and the winner. Cells that
// are not known yet are empty.
std::string ties_csv(const std::vector<Tie>& ties, const RowsById& rows);

// The ties with their scores; the first row is the header.
std::vector<Cells> bracket_rows(const std::vector<Tie>& ties, const RowsById& rows);
inline const std::vector<Align> kBracketColumns = {Align::kLeft, Align::kRight, Align::kLeft,
                                                   Align::kLeft, Align::kLeft,  Align::kLeft};

// One team of a tie, as a bracket shows it.
struct TieTeam {
  std::string name;       // or where it will come from: "winner of quarter-final 2"
  bool is_known = false;  // whether the name is a team's
  std::string goals;      // "1", "1 (4)" with a shoot-out; empty before the first game
  bool has_won = false;
};

struct TieResult {
  std::string name;  // of the tie
  std::optional<BracketPlace> place;
  std::array<TieTeam, 2> teams;
  std::string decision;  // "extra time", "goals in game 3"; empty before the first game
};

// The ties with what is known about them, in the same order.
std::vector<TieResult> tie_results(const std::vector<Tie>& ties, const RowsById& rows);

// The same as lines of text, followed by the winner.
TextBlocks bracket_table(const std::vector<Tie>& ties, const RowsById& rows);

}  // namespace autoref::runner
