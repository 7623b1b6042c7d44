// The box that an optimiser searches.
#pragma once

#include <vector>

#include "runner/tune/optimiser.hpp"

namespace autoref::runner {

// The starts of the axes.
Point start_of(const std::vector<Axis>& axes);

// The point of the box that is nearest.
Point clipped(const Point& point, const std::vector<Axis>& axes);

}  // namespace autoref::runner
