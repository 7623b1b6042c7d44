#include "experiments/statistics/holm.hpp"

#include <algorithm>
#include <numeric>

namespace autoref::experiments {

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> smallest_first(p.size());
  std::iota(smallest_first.begin(), smallest_first.end(), std::size_t{0});
  std::stable_sort(smallest_first.begin(), smallest_first.end(),
                   [p](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  // The i-th smallest of m p values is multiplied by m - i + 1; the running maximum keeps the
  // order.
  std::vector<double> corrected(p.size());
  double least = 0;
  std::size_t left = p.size();
  for (const std::size_t i : smallest_first) {
    least = std::max(least, std::min(1.0, static_cast<double>(left--) * p[i]));
    corrected[i] = least;
  }
  return corrected;
}

}  // namespace autoref::experiments
