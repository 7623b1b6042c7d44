// A person's own list of calls in a recorded game.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "logs/calls.hpp"

namespace autoref::logs {

// Reads CSV with the head "time,call,side", rows in any order; the result is in order of time.
//   time  seconds from the start of the log, or minutes and seconds: 83.2 or 1:23.2
//   call  an event that AutoRef may call (referee/README.md), such as throw_in
//   side  yellow or blue: the team that scored or, for other calls, the offender; empty if unknown
// Throws InputError with `file` and line.
std::vector<Call> annotations_in(std::string_view text, const std::string& file);

}  // namespace autoref::logs
