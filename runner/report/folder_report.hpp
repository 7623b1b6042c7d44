// Reports of a results folder (one per build if there are several), and whether existing reports
// are up to date.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/report/report.hpp"

namespace autoref::runner {

// The report of one build.
struct FolderReport {
  ResultFolder folder;
  std::filesystem::path into;  // the results folder, or a subfolder
  ExperimentResults results;
  WrittenReport report;
};

// Writes the report of `build`. If `build` is empty: the report of the only build, or one for each
// of several builds in its own subfolder, with an overview.
std::vector<FolderReport> write_folder_reports(const std::filesystem::path& path,
                                               const std::string& build);

// "report.html lacks 3 of the 12 games; update it with: autoref report DIR". Empty if this build
// has no report, or one that covers the rows that count.
std::string report_shortfall(const ResultFolder& folder);

// Rewrites an existing report that is out of date according to report_shortfall(). Returns its
// path, or an empty path if there was nothing to do.
std::filesystem::path refresh_report(const ResultFolder& folder);

}  // namespace autoref::runner
