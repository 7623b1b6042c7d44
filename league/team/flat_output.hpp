// Reading of outputs in the flat encoding.
#pragma once

#include <optional>
#include <string_view>

#include "league/team/team_codec.hpp"

namespace autoref::league {

// As TeamCodec::find_message() and TeamCodec::read().
std::optional<MessageExtent> find_flat_output(std::string_view bytes);
void read_flat_output(std::string_view content, TeamOutput& output);

}  // namespace autoref::league
