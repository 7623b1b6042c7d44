// The registered teams and their tunable parameters, as text and as JSON.
#pragma once

#include <string>

#include "io/table.hpp"
#include "strategies/registry.hpp"

namespace autoref::app {

// One line per team: name and description.
io::TextBlocks teams_text();

// All teams as one JSON object, each in the format of team_json().
std::string teams_json();

// A team's description and one line per parameter: name, unit, default, range, description.
io::TextBlocks team_text(const strategies::Entry& team);

// The team as one JSON object.
std::string team_json(const strategies::Entry& team);

}  // namespace autoref::app
