// Reports of a results folder, one per build if it has games played by several builds, and a check
// whether existing reports are up to date.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/report/report.hpp"
#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

// Subfolder of the results folder for a build's report: "build-1.0.0-5bfc77ad2f0a". Throws
// InputError if a row's build is not a valid folder name.
std::filesystem::path build_folder(const std::filesystem::path& path, const std::string& build);

struct BuildReport {
  ResultFolder folder;
  std::string table;  // table of the results, as text
};

// Writes report.md and report.html into the results folder: the number of games played by each
// build, its table, and the location of its report. `builds` must not be empty.
void write_overview(const std::filesystem::path& path, const std::vector<BuildReport>& builds);

// The report of one build.
struct FolderReport {
  ResultFolder folder;
  std::filesystem::path into;  // the results folder, or a subfolder
  ExperimentResults results;
  std::optional<WrittenReport> report;  // nullopt if nothing was written
};

// Whether results.csv may be replaced by a new one that lacks the games that have lost their rows.
enum class LostGames : std::uint8_t { kKeep, kDrop };

// Writes the report of `build`. If `build` is empty, writes the report of the only build. If there
// are several builds, writes an overview and one report per build, each in its own subfolder. With
// kKeep, writes nothing for a build if games in results.csv no longer have rows
// (ResultFolder::lost).
std::vector<FolderReport> write_folder_reports(const std::filesystem::path& path,
                                               const std::string& build,
                                               LostGames lost = LostGames::kKeep);

// "report.html lacks 3 of the 12 games; update it with: autoref report DIR". Empty if this build
// has no report or if its report covers all rows that count.
std::string report_shortfall(const ResultFolder& folder);

// Rewrites an existing report that is out of date according to report_shortfall(). Returns its
// path, or an empty path if there was nothing to do.
std::filesystem::path refresh_report(const ResultFolder& folder);

}  // namespace autoref::experiments
