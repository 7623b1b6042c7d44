// Tests whether two paths lead to the same file.
#pragma once

#include <filesystem>

namespace autoref::io {

// Returns whether both paths lead to the same file, whatever their links and spellings, even if the
// file does not exist yet.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// Returns whether `descriptor` is open on this file; always false for terminals and pipes.
bool is_open_as(const std::filesystem::path& path, int descriptor);

}  // namespace autoref::io
