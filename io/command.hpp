// Runs external programs and collects their output, and measures processes' processor time.
#pragma once

#include <sys/resource.h>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace autoref::io {

// User and system time together, in s: Linux measures the sum exactly but only estimates how it is
// split.
inline double processor_s(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Processor time used so far by `whose` processes: RUSAGE_SELF, or RUSAGE_CHILDREN, which counts
// only children that have ended and been waited for.
inline double processor_s_of(int whose) {
  rusage usage{};
  getrusage(whose, &usage);
  return processor_s(usage);
}

inline constexpr double kUnlimited_s = std::numeric_limits<double>::infinity();

struct CommandResult {
  int code = 0;     // the program's exit code, or 128 plus the number of the signal that ended it
  std::string out;  // the program's stdout; its stderr goes to AutoRef's stderr
  double processor_s = 0;  // the program's processor time, including children it waited for
  bool is_late = false;    // killed because it took too long
};

// Runs a program found in PATH and waits for it to end, for at most `longest_s`. No shell
// interprets the arguments. Returns nullopt if there is no such program. Throws InputOutputError if
// no process can be started.
std::optional<CommandResult> run_command(const std::vector<std::string>& words,
                                         double longest_s = kUnlimited_s);

}  // namespace autoref::io
