// Reads an event log, as written by `autoref play --events` (event_log.hpp), for a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/view/recorded_decision.hpp"

namespace autoref::runner {

// Parses `lines`, one JSON object per line. Throws InputError with `file` and the line's number if
// a line is not a decision.
std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file);

}  // namespace autoref::runner
