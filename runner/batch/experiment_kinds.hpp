// What differs between the kinds of experiments: which games they play, and what their rows say.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/analysis/standings.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/io/json.hpp"
#include "runner/processes/standings_table.hpp"
#include "runner/results/row_format.hpp"

namespace autoref::runner {

// Whether the scenario is an experiment of teams, which `autoref run` plays: all but a single game
// and games for the referee.
bool is_experiment(const Scenario& scenario);

// Whether the rows of its games are kept: all but a single game. The other functions take no other.
bool keeps_rows(const Scenario& scenario);

// Its games in the order in which they are played, as far as they are known beforehand. Throws
// std::invalid_argument where settings do not go together.
std::vector<ScheduledGame> scheduled_games(const Scenario& scenario);

// In which way the games may yet be others than plan() says; empty where they may not.
std::string caveat_of_schedule(const Scenario& scenario);

// Which games an experiment takes, as far as its rows tell.
struct Schedule {
  std::vector<ScheduledGame> games;  // in the order in which they are played
  // How many it takes: the first of `games`, so that others do not count; or more than `games`,
  // where those to come are not known yet.
  std::size_t needed = 0;
};

// `rows` are those of its games so far.
Schedule schedule_of(const Scenario& scenario, const RowsById& rows);

// Whether its course may change with its rows: a match ends with the pair that decides it, and who
// meets whom in a knockout follows from the ties before.
bool follows_its_rows(const Scenario& scenario);

// Whether these rows make all games superfluous that are not played yet.
bool is_decided(const Scenario& scenario, const RowsById& rows);

// The rows of needed games: those that results are made of.
RowsById counted(const Schedule& schedule, const RowsById& rows);

// The columns of its rows that hold the factors' values.
std::vector<std::string> value_columns(const Scenario& scenario);

// What its rows look like.
RowFormat row_format(const Scenario& scenario);

// The settings in which two experiments of one kind differ: "match.half_s is 60.0 here and 600.0
// there; ...". Empty where there are none, or where the kinds are not the same. Factors' values,
// and teams that one of them has not, make other games and do not count.
std::string changes_between(const Scenario& here, const Scenario& there);

// A file that a complete experiment leaves beside results.csv.
struct ResultFile {
  std::string name;   // such as "summary.csv"
  std::string about;  // what a row is
  std::string content;
};

struct ExperimentResults {
  std::vector<Group> groups;        // of a sweep's values, or of matchups; a knockout has none
  std::vector<Standing> standings;  // of a round robin or of challengers, best team first
  std::vector<ResultFile> files;
  std::string table;                 // for people
  std::vector<ProgressTable> shown;  // the same for a screen, as a run shows it
  std::shared_ptr<const Json> json;  // and for programs: an object
};

// The results of the games that count. Not for judged games, whose results are in runner/judge.
ExperimentResults results_of(const Scenario& scenario, const RowsById& rows);

}  // namespace autoref::runner
