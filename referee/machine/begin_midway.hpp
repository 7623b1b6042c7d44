// Games that begin in the middle of a half (referee/beginning.hpp).
#pragma once

#include <span>

#include "referee/machine/machine.hpp"

namespace autoref::referee {

// Tried before all others: without a Beginning, none of them applies.
std::span<const Transition> transitions_midway();

}  // namespace autoref::referee
