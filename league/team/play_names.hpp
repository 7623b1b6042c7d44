// Names of what is being played.
#pragma once

#include <string_view>

#include "soccer/situation.hpp"

namespace autoref::league {

// In the manner of the league's commands, for example "PREPARE_KICKOFF".
std::string_view name_of(Play play);

}  // namespace autoref::league
