// What a folder holds that is not a whole results folder.
#pragma once

#include <filesystem>
#include <string>

namespace autoref::experiments {

// Says what is there and what to do, for a folder without effective.yaml or without its folder
// games: "holds no results: ...".
std::string missing_results_text(const std::filesystem::path& folder);

}  // namespace autoref::experiments
