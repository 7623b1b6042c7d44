// The argument FILE of verbs that read a scenario or a scene.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

namespace autoref::runner {

// Adds the argument, which is required unless the caller changes that. `file` gets its value by
// found_scenario() of the running program; if it is an installed file, a message on stderr names
// it.
CLI::Option* add_scenario_argument(CLI::App& verb, std::string& file, const std::string& about);

// `file` if it exists; otherwise the file of that name that was installed with `program`
// (runner/io/installed_files.hpp); if there is none, `file`.
std::string found_scenario(const std::string& file, const std::filesystem::path& program);

}  // namespace autoref::runner
