#include "experiments/analysis/result_shares.hpp"

#include <fmt/format.h>

namespace autoref::experiments {

std::string share_text(int part, int whole) {
  const std::optional<Interval> interval = proportion_interval(part, whole);
  if (!interval) return "-";
  return fmt::format("{:.0f} % [{:.0f}, {:.0f}]", 100.0 * part / whole, 100 * interval->low,
                     100 * interval->high);
}

}  // namespace autoref::experiments
