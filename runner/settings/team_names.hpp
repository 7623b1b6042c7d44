// What people call the teams of a game.
#pragma once

#include <string>

#include "runner/settings/configuration.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

// The name of each side's team: its strategy, and where both have the same one, "basic (a)" and
// "basic (b)".
PerSide<std::string> shown_names(const GameConfiguration& game);

}  // namespace autoref::runner
