// The colours of the sides, as people and the league name them.
#pragma once

#include <string_view>

#include "soccer/side.hpp"

namespace autoref {

// "yellow" of the west, "blue" of the east.
constexpr std::string_view colour_of(Side side) { return side == Side::kWest ? "yellow" : "blue"; }

}  // namespace autoref
