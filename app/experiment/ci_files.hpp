// The files of `autoref compare --ci`.
#pragma once

#include <filesystem>
#include <string>

#include "app/experiment/ci_report.hpp"

namespace autoref::app {

inline constexpr const char* kCiMarkdown = "comparison.md";
inline constexpr const char* kCiJunit = "junit.xml";

// Creates the folder, checks that both files can be written, and removes those of an earlier
// comparison: if this one does not get as far as an answer, old files would be taken for its own.
// Call this function before playing. Throws InputError naming --ci.
void prepare_ci_folder(const std::filesystem::path& folder);

// Each file appears complete or not at all. Throws InputOutputError.
void write_ci_files(const CiReport& report, const std::filesystem::path& folder);

}  // namespace autoref::app
