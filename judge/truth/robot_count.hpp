// Number of robots that a side has on the field.
#pragma once

#include "judge/truth/scene.hpp"

namespace autoref::judge::ground_truth {

int robots_on_field(const Scene& scene, Side side);

// Returns whether the side has more robots on the field than the signal allows.
bool has_surplus(const Scene& scene, Side side);

}  // namespace autoref::judge::ground_truth
