// Number of robots that a side has on the field.
#pragma once

#include "runner/judge/truth/scene.hpp"

namespace autoref::runner::ground_truth {

int robots_on_field(const Scene& scene, Side side);

// Returns whether the side has more robots on the field than the signal allows.
bool has_surplus(const Scene& scene, Side side);

}  // namespace autoref::runner::ground_truth
