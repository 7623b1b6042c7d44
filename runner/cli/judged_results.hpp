// What verbs write and print of judged games.
#pragma once

#include <filesystem>
#include <string>

#include "runner/batch/result_folder.hpp"
#include "runner/judge/judge_report.hpp"

namespace autoref::runner {

bool is_judged(const Scenario& scenario);

// judge.csv and faults.csv.
void write_judged(const std::filesystem::path& folder, const JudgeReport& report);
void print_judged_files(const std::filesystem::path& folder);

// These and report.md and report.html, into `into`; prints them and the tables. Gives the table of
// scores.
std::string report_judged(const ResultFolder& folder, const std::filesystem::path& into);

// report_judged() for a folder's rows of `build`; where that is empty, of the only build, or of
// each into a folder of its own, with an overview.
void report_judged_builds(const std::filesystem::path& path, const std::string& build);

}  // namespace autoref::runner
