// Folders that hold games of several builds: each is reported apart, none is mixed with another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"

namespace autoref::runner {

// Where a build's report goes in the folder of results: "build-0.1.0-5bfc77ad2f0a". Throws
// InputError where a row's build is no name that a folder may have.
std::filesystem::path build_folder(const std::filesystem::path& path, const std::string& build);

struct BuildReport {
  ResultFolder folder;
  std::string table;  // for people
};

// Writes report.md and report.html into the folder of results: how many games each build has, its
// table, and where its report is. There is at least one build.
void write_overview(const std::filesystem::path& path, const std::vector<BuildReport>& builds);

}  // namespace autoref::runner
