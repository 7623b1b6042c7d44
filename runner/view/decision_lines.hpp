// The referee's decisions as event_log.hpp writes them, read back for a page.
#pragma once

#include <string>
#include <string_view>

namespace autoref::runner {

// A JSON list of what people want to see of the decisions in `lines`, one JSON object a line;
// those that say only that the game takes its course are left out. Throws InputError with `file`
// and the line's number where a line is none.
std::string decisions_for_page(std::string_view lines, const std::string& file);

}  // namespace autoref::runner
