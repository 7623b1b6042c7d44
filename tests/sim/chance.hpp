// Random numbers for tests that try many cases.
#pragma once

#include "soccer/random.hpp"

namespace autoref::sim {

// One uniform draw.
inline double between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

}  // namespace autoref::sim
