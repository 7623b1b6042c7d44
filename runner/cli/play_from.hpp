// Games that begin where a log is at some time.
#pragma once

#include <string>

#include "runner/cli/command_line.hpp"
#include "runner/settings/assignments.hpp"

namespace autoref::runner {

struct PlayedInstant {
  std::string log;
  double at_s = 0;  // from the start of the log
};

// Parses LOG@SECONDS. Throws InputError naming --from.
PlayedInstant instant_in(const std::string& from);

// The game of `arguments.file`, beginning where the log is at that time. Without a scenario, field
// and numbers of robots are the log's, unless they are set. Throws InputError.
GameSettings game_from_log(const PlayArguments& arguments, const Assignments& assignments);

}  // namespace autoref::runner
