// Judged games as rows of a results folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runner/batch/outcomes.hpp"
#include "runner/batch/program_files.hpp"
#include "runner/batch/result_folder.hpp"
#include "runner/experiments/kinds/judge/judge_schedule.hpp"
#include "runner/judge/evaluate_calls.hpp"
#include "runner/judge/judge_report.hpp"

namespace autoref::runner {

// Fills the row of a judged game. The game is void if its evaluation is too long for a row.
void keep(JudgedGame judged, GameRow& row);

// Plays a game, evaluates its referee and fills its row. Throws what play() and the programs' files
// throw.
void play_judged(const GameConfiguration& game, GamePrograms& programs, GameRow& row);

// How `autoref judge` plays its games, and the table that it shows meanwhile. `folder` takes what
// programs leave.
Outcomes judged_outcomes(const JudgeSchedule& schedule, const std::filesystem::path& folder);

JudgeReport report_of(const ResultFolder& folder);

// A game found in a folder by look_up().
struct LookedUp {
  std::string game_id;
  std::string fault;  // "missed throw_in of west at 12.345 s"; empty if a game was requested
};

// Finds a game by a fault's id or by its name in faults.csv, such as
// "2014+none+basic~basic-p0002-1-f3" or "2014 none basic~basic 3"; nullopt if the folder has no
// such game or fault.
std::optional<LookedUp> look_up(const ResultFolder& folder, const std::string& id);

}  // namespace autoref::runner
