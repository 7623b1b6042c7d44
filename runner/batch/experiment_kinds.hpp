// Everything that depends on an experiment's kind: which games it plays and how its rows are
// summarised.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runner/analysis/effects.hpp"
#include "runner/analysis/groups.hpp"
#include "runner/analysis/knockout_report.hpp"
#include "runner/analysis/standings.hpp"
#include "runner/analysis/tuning_state.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/io/json.hpp"
#include "runner/io/table.hpp"
#include "runner/processes/standings_table.hpp"
#include "runner/results/row_format.hpp"

namespace autoref::runner {

// Whether the scenario is an experiment with teams, to be played by `autoref run` or `autoref
// tune`: every kind except single games and `kind: judge`.
bool is_experiment(const Scenario& scenario);

// Whether it is a tuning, to be played by `autoref tune`.
bool is_tuning(const Scenario& scenario);

// Whether the scenario's games are stored as rows: every kind except single games. The functions
// below require this.
bool keeps_rows(const Scenario& scenario);

// The games known in advance, in playing order. Throws std::invalid_argument if the settings
// contradict each other.
std::vector<ScheduledGame> scheduled_games(const Scenario& scenario);

// How the games actually played may differ from scheduled_games(), for messages; empty if they
// cannot differ.
std::string caveat_of_schedule(const Scenario& scenario);

// The games an experiment needs, given its rows so far.
struct Schedule {
  std::vector<ScheduledGame> games;  // in playing order
  // Number of games needed. If less than games.size(), only the first ones count; if more, some
  // future games are not known yet.
  std::size_t needed = 0;
};

// `rows` are those of the games played so far.
Schedule schedule_of(const Scenario& scenario, const RowsById& rows);

// Whether the schedule depends on the rows: an SPRT match ends with the pair that decides it, the
// pairings of a knockout depend on earlier ties, and a tuning's parameters on earlier iterations.
bool follows_its_rows(const Scenario& scenario);

// Whether these rows make all remaining games unnecessary.
bool is_decided(const Scenario& scenario, const RowsById& rows);

// The rows of needed games, which the results are computed from.
RowsById counted(const Schedule& schedule, RowsById rows);

// Names of the row columns with the factors' values.
std::vector<std::string> value_columns(const Scenario& scenario);

// The format of the scenario's rows.
RowFormat row_format(const Scenario& scenario);

// The settings in which two experiments of one kind differ: "match.half_s is 60.0 here and 600.0
// there; ...". Empty if no setting differs or if the kinds differ. Ignores factor values and teams
// that occur in only one of the experiments, since they belong to different games.
std::string changes_between(const Scenario& here, const Scenario& there);

// A file that a complete experiment writes in addition to results.csv.
struct ResultFile {
  std::string name;   // such as "summary.csv"
  std::string about;  // description of its rows
  std::string content;
};

struct ExperimentResults {
  std::vector<Group> groups;        // per value of a sweep or per matchup; empty for a knockout
  std::vector<Effect> effects;      // of a sweep's factors; empty unless it has several
  std::vector<Standing> standings;  // of a round robin or of challengers, best team first
  std::vector<TieResult> ties;      // of a knockout, round by round
  std::shared_ptr<const TuningState> tuning = {};  // null for other kinds
  std::vector<ResultFile> files;
  TextBlocks table;                  // for the terminal and the report
  std::vector<ProgressTable> shown;  // the same for the terminal while the experiment runs
  std::shared_ptr<const Json> json;  // the same as a JSON object
};

// Computes the results from the rows that count. Throws std::logic_error for `kind: judge`; its
// results are computed in runner/judge.
ExperimentResults results_of(const Scenario& scenario, const RowsById& rows);

}  // namespace autoref::runner
