// Judged games as rows of a folder of results: what a row keeps, and what follows from all of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/batch/outcomes.hpp"
#include "runner/batch/result_folder.hpp"
#include "runner/experiments/judge_schedule.hpp"
#include "runner/judge/judge_report.hpp"

namespace autoref::runner {

// The cells of evaluation_columns() (rows.hpp), and back. A row's game is void where it has a
// reason, or where its text is too long for a row. Throws std::invalid_argument if it is not an
// evaluation.
Cells evaluation_cells(const CallEvaluation& evaluation);
CallEvaluation evaluation_in_row(const RowFormat& format, const Cells& row);

// Plays a game and judges its referee.
Cells judged(const GameConfiguration& game);

// What `autoref judge` keeps of games, and the table that it shows meanwhile.
Outcomes judged_outcomes(const JudgeSchedule& schedule, const RowFormat& format);

// Of the games that have rows, in the schedule's order. The same rows give the same report, in
// whatever order they came. Throws InputError where a row holds no evaluation.
JudgeReport report_of(const ResultFolder& folder);

// A game of a folder that somebody wants to see again.
struct LookedUp {
  std::string game_id;
  std::string fault;  // "missed throw_in of west at 12.345 s"; empty where a game was meant
};

// By a fault's id or game in faults.csv, such as "2014+none+basic~basic-p0002-1-f3" or "2014 none
// basic~basic 3"; none where the folder has no such game or fault.
std::optional<LookedUp> look_up(const ResultFolder& folder, const std::string& id);

}  // namespace autoref::runner
