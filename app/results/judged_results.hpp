// Output of the verbs that judge games or report on judged games.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "experiments/report/folder_report.hpp"
#include "experiments/run/result_folder.hpp"
#include "judge/judge_report.hpp"

namespace autoref::app {

bool is_judged(const experiments::Scenario& scenario);

// Writes judge.csv and faults.csv.
void write_judged(const std::filesystem::path& folder, const judge::JudgeReport& report);
// Prints the report on standard output: Markdown, or, on a terminal, tables that fit its width.
void print_judged(const judge::JudgeReport& report);

// Prints only the table of F1 by rule book.
void print_judged_scores(const judge::JudgeReport& report);

void print_judged_files(const std::filesystem::path& folder);

// Writes judge.csv, faults.csv, report.md and report.html into `into`, and prints their paths and
// the tables. With kKeep, writes nothing if rows are damaged. Returns the table of scores.
std::string report_judged(const experiments::ResultFolder& folder,
                          const std::filesystem::path& into, experiments::LostGames lost);

// Calls report_judged() for the rows of `build`. If `build` is empty, reports on the folder's only
// build. If there are several builds, reports on each of them in its own folder and adds an
// overview. Returns ResultFolder::faults() of all these builds.
std::set<std::string> report_judged_builds(const std::filesystem::path& path,
                                           const std::string& build, experiments::LostGames lost);

}  // namespace autoref::app
