// The colours of the sides.
#pragma once

#include <string_view>

#include "soccer/side.hpp"

namespace autoref {

// "yellow" for west, "blue" for east.
constexpr std::string_view colour_of(Side side) { return side == Side::kWest ? "yellow" : "blue"; }

}  // namespace autoref
