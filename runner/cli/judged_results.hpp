// Output of the verbs that judge games or report on judged games.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "runner/batch/result_folder.hpp"
#include "runner/judge/judge_report.hpp"
#include "runner/report/folder_report.hpp"

namespace autoref::runner {

bool is_judged(const Scenario& scenario);

// Writes judge.csv and faults.csv.
void write_judged(const std::filesystem::path& folder, const JudgeReport& report);
// Prints the report on standard output: Markdown, or tables that fit if it is a terminal.
void print_judged(const JudgeReport& report);

// Prints only the table of F1 by rule book.
void print_judged_scores(const JudgeReport& report);

void print_judged_files(const std::filesystem::path& folder);

// Writes judge.csv, faults.csv, report.md and report.html into `into`, and prints their paths and
// the tables. With kKeep, writes nothing if rows are damaged. Returns the table of scores.
std::string report_judged(const ResultFolder& folder, const std::filesystem::path& into,
                          LostGames lost);

// Calls report_judged() for the rows of `build`. If `build` is empty, reports on the folder's only
// build, or, if there are several builds, on each of them in its own folder, and adds an overview.
// Returns ResultFolder::faults() of all of them.
std::set<std::string> report_judged_builds(const std::filesystem::path& path,
                                           const std::string& build, LostGames lost);

}  // namespace autoref::runner
