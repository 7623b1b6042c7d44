// Random numbers for scenes that try many cases.
#pragma once

#include "soccer/random.hpp"

namespace autoref::sim {

// One draw, evenly spread.
inline double between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

}  // namespace autoref::sim
