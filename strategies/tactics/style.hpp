// The tunables of teams that are built from these tactics.
#pragma once

#include "soccer/parameters.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {

// The parameters in style.def, each with its default. Teams differ in their defaults.
struct Style {
#define AUTOREF_TUNABLE(type, name, value, ...) type name = value;
#include "strategies/tactics/style.def"
#undef AUTOREF_TUNABLE

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
#define AUTOREF_TUNABLE(type, name, value, range, about) visitor(self.name, {#name, range, about});
#include "strategies/tactics/style.def"
#undef AUTOREF_TUNABLE
  }
};

}  // namespace autoref::strategies
