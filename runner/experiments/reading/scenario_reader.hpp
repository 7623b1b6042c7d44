// Reads scenario files, of every kind.
#pragma once

#include <filesystem>
#include <string>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// Reads a scenario strictly: every key must be known and given once, every value in its range.
// What is not given has its default. Throws InputError with file, line and key.
Scenario read_scenario(const std::filesystem::path& file);
Scenario read_scenario_text(const std::string& text, const std::string& file_name);

}  // namespace autoref::runner
