// Tests whether two paths lead to the same file.
#pragma once

#include <filesystem>

namespace autoref::runner {

// Returns whether both lead to the same file, through any links and spellings, even if it does not
// exist yet.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// Returns whether the file is the one open as `descriptor`; false for terminals and pipes.
bool is_open_as(const std::filesystem::path& path, int descriptor);

}  // namespace autoref::runner
