// The SCENARIO argument of verbs that read a scenario or a scene.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace autoref::app {

// Adds the argument, which is required unless the caller changes that. `file` is set to the result
// of scenario_to_read().
CLI::Option* add_scenario_argument(CLI::App& verb, std::string& file, const std::string& about);

// Returns found_scenario() for the running program. If the result differs from `given`, a message
// on stderr names it. Throws InputError if only a file with a similar name exists.
std::string scenario_to_read(const std::string& given);

// `file` if it exists; otherwise the file of that name installed with `program` (io/files.hpp), in
// the folder scenarios of the current directory, or in the installed folder scenarios. If there is
// none, returns `file`.
std::string found_scenario(const std::string& file, const std::filesystem::path& program);

// The names of scenarios that found_scenario() would find: the files *.yaml in the current
// directory, in `folder`, and in the local or installed folder scenarios and its subfolders.
// Returns at most a few thousand names, sorted.
std::vector<std::string> known_scenarios(const std::filesystem::path& folder,
                                         const std::filesystem::path& program);

}  // namespace autoref::app
