#include "experiments/kinds/results.hpp"

#include <fmt/format.h>

namespace autoref::experiments {

std::string name_of_round(std::size_t ties_in_round) {
  if (ties_in_round == 1) return "final";
  if (ties_in_round == 2) return "semi-finals";
  if (ties_in_round == 4) return "quarter-finals";
  return fmt::format("round of {}", 2 * ties_in_round);
}

}  // namespace autoref::experiments
