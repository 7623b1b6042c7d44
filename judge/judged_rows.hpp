// Judged games as rows of a results folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/run/program_versions.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/run/run_experiment.hpp"
#include "judge/evaluate_calls.hpp"
#include "judge/judge_report.hpp"

namespace autoref::judge {

// Fills the row of a judged game. The game is void if its evaluation is too long for a row.
void keep(EvaluatedGame judged, experiments::GameRow& row);

// Plays a game, evaluates its referee and fills its row. Throws whatever play() and the programs'
// files throw.
void play_judged(const game::GameConfiguration& game, game::GamePrograms& programs,
                 experiments::GameRow& row);

// How `autoref judge` plays its games, and the table that it shows while playing them. The
// programs' files go into `folder`.
experiments::Outcomes judged_outcomes(const experiments::JudgeSchedule& schedule,
                                      const std::filesystem::path& folder);

JudgeReport report_of(const experiments::ResultFolder& folder);

// A game found in a folder by find_game().
struct FoundGame {
  std::string game_id;
  std::string fault;  // "missed throw_in of west at 12.345 s"; empty if the id is that of a game
};

// Finds a game by a fault's id or by its name in faults.csv, such as
// "2014+none+basic~basic-p0002-1-f3" or "2014 none basic~basic 3"; nullopt if the folder has no
// such game or fault.
std::optional<FoundGame> find_game(const experiments::ResultFolder& folder, const std::string& id);

}  // namespace autoref::judge
