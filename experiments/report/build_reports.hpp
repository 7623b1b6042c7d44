// Reports on folders with games of several builds: one report per build, never mixed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

// Subfolder of the results folder for a build's report: "build-1.0.0-5bfc77ad2f0a". Throws
// InputError if a row's build is not a valid folder name.
std::filesystem::path build_folder(const std::filesystem::path& path, const std::string& build);

struct BuildReport {
  ResultFolder folder;
  std::string table;  // as text
};

// Writes report.md and report.html into the results folder: the number of games of each build, its
// table, and the location of its report. `builds` must not be empty.
void write_overview(const std::filesystem::path& path, const std::vector<BuildReport>& builds);

}  // namespace autoref::experiments
