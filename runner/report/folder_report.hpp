// The reports of a folder of results: of one build, or of each where there are several; and whether
// those that are there still hold what the folder does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/report/report.hpp"

namespace autoref::runner {

// One build's.
struct FolderReport {
  ResultFolder folder;
  std::filesystem::path into;  // the folder of results, or one below it
  ExperimentResults results;
  WrittenReport report;
};

// Writes the report of `build` into the folder; where `build` is empty, of the only one that there
// is, or of each of several into a folder of its own, and the overview of these.
std::vector<FolderReport> write_folder_reports(const std::filesystem::path& path,
                                               const std::string& build);

// "report.html lacks 3 of the 12 games; write it again with: autoref report DIR"; empty where no
// report of this build is there, or where it holds the rows that count.
std::string report_shortfall(const ResultFolder& folder);

// Writes a report that is there again where report_shortfall() says so. Returns where it is; empty
// where nothing was to be done.
std::filesystem::path refresh_report(const ResultFolder& folder);

}  // namespace autoref::runner
