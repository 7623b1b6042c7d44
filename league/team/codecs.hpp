// The codec of each encoding, for make_team_codec().
#pragma once

#include <memory>

#include "league/team/team_codec.hpp"

namespace autoref::league {

std::unique_ptr<TeamCodec> make_flat_codec();
std::unique_ptr<TeamCodec> make_json_codec();
std::unique_ptr<TeamCodec> make_league_codec();

// Throws std::invalid_argument if a name in `start` is too long to be sent.
void check_names(const TeamStart& start);

}  // namespace autoref::league
