// Display names of a game's teams.
#pragma once

#include <string>

#include "runner/settings/configuration.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

// The name of each side's team: its strategy, or "basic (a)" and "basic (b)" if both play the same.
PerSide<std::string> shown_names(const GameConfiguration& game);

}  // namespace autoref::runner
