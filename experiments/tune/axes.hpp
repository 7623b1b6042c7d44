// The box that an optimiser searches.
#pragma once

#include <vector>

#include "experiments/tune/optimiser.hpp"

namespace autoref::experiments {

// The starts of the axes.
Point start_of(const std::vector<Axis>& axes);

// The point of the box that is nearest.
Point clipped(const Point& point, const std::vector<Axis>& axes);

}  // namespace autoref::experiments
