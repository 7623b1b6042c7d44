// The number of a side's robots on the field.
#pragma once

#include "judge/truth/true_frame.hpp"

namespace autoref::judge::ground_truth {

int robots_on_field(const TrueFrame& frame, Side side);

// Returns whether the side has more robots on the field than the signal allows.
bool has_surplus(const TrueFrame& frame, Side side);

}  // namespace autoref::judge::ground_truth
