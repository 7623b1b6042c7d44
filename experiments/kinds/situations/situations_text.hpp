// Situations as text.
#pragma once

#include <map>
#include <string>

#include "experiments/kinds/situations/situations.hpp"

namespace autoref::experiments {

// The key `situations` of effective.yaml, with every number.
std::string situations_text(const Situations& situations);

// The same as values by path, such as "situations.corner.attackers.1.x_m".
std::map<std::string, std::string> situation_values(const Situations& situations);

}  // namespace autoref::experiments
