// The results computed from an experiment's rows, in the forms shared by all kinds, and the usual
// results of groups and tournaments.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/effects.hpp"
#include "experiments/analysis/groups.hpp"
#include "experiments/analysis/standings.hpp"
#include "experiments/analysis/summary.hpp"
#include "experiments/analysis/version_ratings.hpp"
#include "experiments/statistics/sequential_test.hpp"
#include "io/json.hpp"
#include "io/processes/standings_table.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// The position of a tie in a bracket, where the winners of ties 2p and 2p + 1 of a round play tie p
// of the next round.
struct BracketPlace {
  // Number of ties in its round, including byes: 1 for the final, 2 for the semi-finals, ...
  std::size_t ties_in_round = 1;
  std::size_t position = 0;  // position in the round, counted from 0
  bool operator==(const BracketPlace&) const = default;
};

// "final", "semi-finals", "quarter-finals", "round of 16", ...
std::string name_of_round(std::size_t ties_in_round);

// One team of a tie, as shown in a bracket.
struct TieTeam {
  // The team's name, or where the team will come from: "winner of quarter-final 2".
  std::string name;
  bool is_known = false;  // whether `name` is a team's name
  std::string goals;      // such as "1", or "1 (4)" after a shoot-out; empty before the first game
  bool has_won = false;
};

struct TieResult {
  std::string name;  // name of the tie
  std::optional<BracketPlace> place;
  std::array<TieTeam, 2> teams;
  std::string decision;   // "extra time", "goals in game 3"; empty before the first game
  bool is_usual = false;  // whether the tie was decided by goals in its first game
};

// A parameter's values during a search.
struct SearchedParameter {
  std::string name;
  double from = 0;  // lower end of its range
  double to = 1;
  double start = 0;
  std::vector<double> values;  // position of the search after each iteration,
  std::vector<double> best;    // and the best value known after it
};

struct SearchPath {
  int iterations = 0;  // number of iterations planned
  std::vector<SearchedParameter> parameters;
};

// Whether the new team of a comparison is better than the old one.
struct ComparisonAnswer {
  ThreeWayVerdict verdict = ThreeWayVerdict::kGoOn;
  std::string sentence;
  // Which part of the difference, and which difference in play, is most certain: a line each; empty
  // without pairs.
  std::string reason;
  io::TextBlocks opponents;  // the table of opponents with its notes
  io::TextBlocks parts;      // the parts of the difference; empty without pairs
  io::TextBlocks play;       // the differences in play; empty if none is certain
};

// A file that a complete experiment writes in addition to results.csv.
struct ResultFile {
  std::string name;   // such as "summary.csv"
  std::string about;  // description of its rows
  std::string content;
};

// A drawing for the report. It is also written as a file.
struct ResultDrawing {
  std::string name;  // "midfield-2.svg"
  std::string caption;
  std::string svg;  // SVG source
};

struct ExperimentResults {
  std::vector<Group> groups;             // groups per value or per matchup; empty if there are none
  bool are_compared_with_first = false;  // whether the table compares the groups with the first
  // Slope of the goal difference over the value of a single factor.
  std::optional<Slope> slope;
  // Effects of the factors of a sweep with several factors; otherwise empty.
  std::vector<Effect> effects;
  // Of the teams or challengers, best team first; empty if there are none.
  std::vector<Standing> standings;
  // Versions of teams by line and date, then other rated teams; empty unless ratings are followed
  // over time.
  std::vector<VersionRating> versions;
  std::vector<TieResult> ties;  // ties of a bracket, round by round; empty if there is none
  std::optional<SearchPath> search;
  std::optional<ComparisonAnswer> comparison;  // of kind compare; otherwise nullopt
  std::vector<ResultFile> files;
  std::vector<ResultDrawing> drawings;
  io::TextBlocks table;                  // table for the terminal and the report
  std::vector<io::ProgressTable> shown;  // the tables for the terminal while the experiment runs
  std::shared_ptr<const io::Json> json;  // the results as a JSON object
};

// A table of groups while the experiment runs. On a narrow screen, the table first drops two
// columns: the goals, since their difference is shown as well, and the void games, since the
// progress bar counts them.
io::ProgressTable groups_progress_table(std::vector<io::Cells> rows, std::vector<io::Align> columns,
                                        std::string noun);

// A table of matchups while the experiment runs. Like groups_progress_table(), but it can also drop
// the number of games, since it is the sum of the wins, draws and losses on the right.
io::ProgressTable matchups_progress_table(const std::vector<Group>& matchups);

// Adds the differences between the teams to the results of a tournament, if teams have common
// opponents.
void add_team_differences(ExperimentResults& results);

// The results of a tournament. A kind can add files and blocks of the table, which the report then
// shows as well. `noun` is the singular of what the standings list: "team" or "challenger".
ExperimentResults tournament_results(std::vector<Group> matchups, std::vector<Standing> standings,
                                     const std::string& noun);

}  // namespace autoref::experiments
