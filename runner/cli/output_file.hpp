// Files that a flag names for what a verb makes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/io/files.hpp"

namespace autoref::runner {

// A file that a verb reads or writes; the path is empty where none is given.
struct NamedFile {
  std::string flag;  // that names it, such as "--log"
  std::string path;
};

// Throws InputError that names both flags where two outputs are the same file, however their paths
// are spelt, and where an output is one of `inputs` or the file that a standard stream goes to: one
// of the two would be lost. To be called before any work is done. Several outputs may go to one
// terminal or to /dev/null.
void check_outputs(const std::vector<NamedFile>& outputs, const std::vector<std::string>& inputs);

// Opens the file before any work is done, so that a wrong name is noticed at once. None for an
// empty path. Throws InputError that names `flag`.
std::optional<PendingFile>& open_output(std::optional<PendingFile>& file, const char* flag,
                                        const std::string& path);

}  // namespace autoref::runner
