// The number of robots that a side has on the field.
#pragma once

#include "referee/referee_input.hpp"

namespace autoref::referee {

// Counts robots with any part within the lines.
int robots_on_field(const RefereeInput& input, Side side);

}  // namespace autoref::referee
