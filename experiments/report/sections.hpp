// The sections of a report.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/report/document.hpp"
#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

using Section = std::vector<Block>;  // empty if there is nothing to report

// Names of those rows of the table in played_section() that identify a report's state, and the
// values in these rows.
inline constexpr const char* kBuildRow = "build";
inline constexpr const char* kGamesRow = "games";
inline constexpr const char* kChecksumRow = "checksum of the rows";
std::string games_text(const ResultFolder& folder);  // "12 of 24"

// The numbers of games planned and played, and the build that played them. If games are missing,
// warns that the intervals are provisional.
Section played_section(const ResultFolder& folder, const ExperimentResults& results);

// The terminal's table, and the meaning of its intervals.
Section results_section(const ExperimentResults& results);

// Explains how to read the numbers and intervals of the results.
Section meaning_of(const ExperimentResults& results);

// Proportions of games won, drawn and lost, by group and by team in the standings.
Section shares_section(const ResultFolder& folder, const ExperimentResults& results);

// Points and goal difference of each team against every other team.
Section crosstable_section(const ExperimentResults& results);

// The pairings of a knockout, the results so far and the teams that advance.
Section bracket_section(const ExperimentResults& results);

// The drawings that a kind adds to its results, and those over all games that are stored in `into`
// (play_drawings.hpp).
Section drawings_section(const ResultFolder& folder, const ExperimentResults& results,
                         const std::filesystem::path& into);

// The void games and the reasons why they are void.
Section void_section(const ResultFolder& folder);

// A link to all settings, and a list of those that differ from the defaults.
Section settings_section(const ResultFolder& folder, const std::string& direction);

// Commands that replay and verify the games. `direction` is the path from the report to the results
// folder: "." or "..".
Section commands_section(const ResultFolder& folder, const std::string& direction);

// Warning in every report of an incomplete experiment.
inline constexpr const char* kInterimWarning =
    "Do not stop early because of interim intervals: stopping at the first favourable one is wrong "
    "far more often than one time in twenty.";

}  // namespace autoref::experiments
