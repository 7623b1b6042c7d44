// The registered teams that play and obey the rules.
#pragma once

#include <string_view>
#include <vector>

#include "strategies/registry.hpp"

namespace autoref::strategies {

inline std::vector<std::string_view> lawful_teams() {
  std::vector<std::string_view> names;
  for (const Entry& entry : all_strategies()) {
    if (entry.name != "dummy" && entry.name != "rowdy") names.push_back(entry.name);
  }
  return names;
}

}  // namespace autoref::strategies
