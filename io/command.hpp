// Runs external programs and collects their output.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace autoref::io {

inline constexpr double kUnlimited_s = std::numeric_limits<double>::infinity();

struct CommandResult {
  int code = 0;     // the program's exit code, or 128 plus the number of the signal that ended it
  std::string out;  // the program's stdout; its stderr goes to AutoRef's stderr
  double processor_s = 0;  // its processor time, with that of children it waited for
  bool is_late = false;    // killed because it took too long
};

// Runs a program found in PATH and waits until it ends, at most `longest_s`; no shell interprets
// the arguments. Returns nullopt if there is no such program. Throws InputOutputError if no process
// can be started.
std::optional<CommandResult> run_command(const std::vector<std::string>& words,
                                         double longest_s = kUnlimited_s);

}  // namespace autoref::io
