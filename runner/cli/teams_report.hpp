// The registered teams and what they can be tuned with, for people and for scripts.
#pragma once

#include <string>

#include "strategies/registry.hpp"

namespace autoref::runner {

// A line for each team: name and sentence.
std::string teams_text();

// All teams as one JSON object, each as team_json() has it.
std::string teams_json();

// A team's sentence and a line for each of its parameters: name, unit, default, range, sentence.
std::string team_text(const strategies::Entry& team);

// The same as one JSON object.
std::string team_json(const strategies::Entry& team);

}  // namespace autoref::runner
