// What every rule has: the states in which it watches, and a search for a breach or an event.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "referee/finding.hpp"
#include "referee/memory.hpp"
#include "referee/moment.hpp"

namespace autoref::referee {

struct Rule {
  std::string_view name;
  State active_in;
  // What the rule finds in this frame, or none.
  std::optional<Finding> (*find)(const Memory& memory, const Moment& moment);
};

// All rules, in the order in which they are asked: what happens first on the field comes first. A
// robot too near to the area stands there before the kick whose ball goes out in the same frame,
// and a goal is judged before an exit.
std::span<const Rule> rules();

}  // namespace autoref::referee
