// The sections of a report, in words.
#pragma once

#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/report/document.hpp"

namespace autoref::runner {

using Section = std::vector<Block>;  // empty where there is nothing to say

// Rows of what was played, by which a report can be compared with its folder; and their values.
inline constexpr const char* kBuildRow = "build";
inline constexpr const char* kGamesRow = "games";
inline constexpr const char* kChecksumRow = "checksum of the rows";
std::string games_text(const ResultFolder& folder);     // "12 of 24"
std::string rows_checksum(const ResultFolder& folder);  // CRC-32 of results.csv

// What was played, how much of it, and what with. Says that interim intervals are not for stopping
// where games are missing.
Section played_section(const ResultFolder& folder, const ExperimentResults& results);

// The terminal's table, and what its intervals mean.
Section results_section(const ResultFolder& folder, const ExperimentResults& results);

// Shares of games won, drawn and lost: of each group, and of each team that has a standing.
Section shares_section(const ResultFolder& folder, const ExperimentResults& results);

// Points and goal difference of each team against each.
Section crosstable_section(const ExperimentResults& results);

// The games that count nowhere, and why.
Section void_section(const ResultFolder& folder);

// What a reader needs to know of the settings.
Section settings_section(const ResultFolder& folder, const std::string& direction);

// Commands that play and check the same games; `direction` leads from the report to the folder of
// results: "." or "..".
Section commands_section(const ResultFolder& folder, const std::string& direction);

// Said wherever an experiment is not complete.
inline constexpr const char* kInterimWarning =
    "Interim intervals are no reason to stop: who stops at the first that pleases is wrong far "
    "more often than one time in twenty.";

}  // namespace autoref::runner
