// Files that a flag names for what a verb makes.
#pragma once

#include <optional>
#include <string>

#include "runner/io/files.hpp"

namespace autoref::runner {

// Throws InputError where `flag` would write over `source`, the file that it is made of.
void spare_source(const char* flag, const std::string& path, const std::string& source);

// Opens the file before any work is done, so that a wrong name is noticed at once. None for an
// empty path. Throws InputError that names `flag`.
std::optional<PendingFile>& open_output(std::optional<PendingFile>& file, const char* flag,
                                        const std::string& path);

}  // namespace autoref::runner
