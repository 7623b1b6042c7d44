// Runs external programs and collects their output.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace autoref::runner {

struct CommandResult {
  int code = 0;     // the program's exit code, or 128 plus the number of the signal that ended it
  std::string out;  // the program's stdout; its stderr goes to AutoRef's stderr
};

// Runs a program found in PATH and waits until it ends; no shell interprets the arguments. Returns
// nullopt if there is no such program. Throws InputOutputError if no process can be started.
std::optional<CommandResult> run_command(const std::vector<std::string>& words);

}  // namespace autoref::runner
