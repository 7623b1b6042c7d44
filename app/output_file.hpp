// Output files that are named by command-line flags.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/files.hpp"

namespace autoref::app {

// A file that a verb reads or writes.
struct NamedFile {
  std::string flag;  // the flag that names it, such as "--log"
  std::string path;
};

// Throws InputError naming both flags if two outputs are the same file (however their paths are
// spelt), or if an output is one of `inputs` or the file to which a standard stream is redirected,
// since one of the two would be lost. Call this function before doing any work. Several outputs may
// share a terminal or /dev/null.
void check_outputs(const std::vector<NamedFile>& outputs, const std::vector<std::string>& inputs);

// Opens the file before any work is done, so that a wrong name is reported at once. Leaves `file`
// empty if the path is empty. Throws InputError naming `flag`.
std::optional<io::PendingFile>& open_output(std::optional<io::PendingFile>& file, const char* flag,
                                            const std::string& path);

}  // namespace autoref::app
