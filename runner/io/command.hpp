// Programs that others wrote, run for what they print.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace autoref::runner {

struct CommandResult {
  int code = 0;     // its exit code, or 128 and the signal that ended it
  std::string out;  // what it wrote to stdout; its stderr is this program's
};

// Runs a program found in PATH, with the arguments as they are, to its end; none where there is no
// such program. Throws InputOutputError where no process can be started.
std::optional<CommandResult> run_command(const std::vector<std::string>& words);

}  // namespace autoref::runner
