// Runs external programs and collects their output.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace autoref::runner {

struct CommandResult {
  int code = 0;     // its exit code, or 128 plus the number of the signal that ended it
  std::string out;  // its stdout; its stderr goes to this program's stderr
};

// Runs a program found in PATH to its end; the arguments are passed on without a shell. Returns
// nullopt if there is no such program. Throws InputOutputError if no process can be started.
std::optional<CommandResult> run_command(const std::vector<std::string>& words);

}  // namespace autoref::runner
