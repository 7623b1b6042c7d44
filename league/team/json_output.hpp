// Reading of outputs in JSON.
#pragma once

#include <string_view>

#include "league/team/team_messages.hpp"

namespace autoref::league {

// Replaces `output` by the content of a line, given without its end. Throws TeamFault if the line
// is invalid, contains unknown members or a member twice.
void read_json_output(std::string_view line, TeamOutput& output);

}  // namespace autoref::league
