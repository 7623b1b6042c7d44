// Models that are fitted separately for each rule book.
#pragma once

#include <algorithm>
#include <cassert>
#include <span>
#include <string_view>

namespace autoref::game {

// The model for the rule book of that name, which must have one (asserted).
template <typename Model>
const Model& model_for(std::string_view rules, std::span<const Model> models) {
  const auto found = std::find_if(models.begin(), models.end(),
                                  [rules](const Model& one) { return one.rules == rules; });
  assert(found != models.end());
  return *found;
}

}  // namespace autoref::game
