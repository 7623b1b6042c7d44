// Whether two names lead to one file.
#pragma once

#include <filesystem>

namespace autoref::runner {

// Whether both lead to the same file, through whatever links and spellings, also where it does not
// exist yet.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// Whether the file is the one that the open descriptor reads or writes; false for terminals and
// pipes.
bool is_open_as(const std::filesystem::path& path, int descriptor);

}  // namespace autoref::runner
