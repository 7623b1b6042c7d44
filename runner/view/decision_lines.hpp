// Reads an event log, as `autoref play --events` writes it (event_log.hpp), for a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/view/recorded_decision.hpp"

namespace autoref::runner {

// The decisions in `lines`, one JSON object a line. Throws InputError with `file` and the line's
// number where a line is not a decision.
std::vector<RecordedDecision> decisions_in(std::string_view lines, const std::string& file);

}  // namespace autoref::runner
