#include "experiments/statistics/paired_difference.hpp"

#include <algorithm>
#include <numeric>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

// Common random numbers: games with the same pair number have the same seeds, so the luck they
// share cancels in the difference.
std::vector<double> common_differences(const DifferenceByPair& value,
                                       const DifferenceByPair& baseline) {
  std::vector<double> differences;
  for (const auto& [pair, difference] : value) {
    const auto found = baseline.find(pair);
    if (found != baseline.end()) differences.push_back(difference - found->second);
  }
  return differences;
}

}  // namespace

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

PairedDifference paired_difference(const DifferenceByPair& value,
                                   const DifferenceByPair& baseline) {
  const std::vector<double> sample = common_differences(value, baseline);
  PairedDifference difference;
  difference.pairs = sample.size();
  if (sample.empty()) return difference;
  difference.mean = mean(sample);
  difference.interval = mean_interval(sample);
  difference.p = p_of_zero_mean(sample);
  // Cohen's d for paired samples: the mean difference in units of the differences' own spread.
  if (difference.p) difference.effect_size = *difference.mean / *standard_deviation(sample);
  return difference;
}

std::vector<PairedDifference> differences_from_baseline(std::span<const DifferenceByPair> values) {
  std::vector<PairedDifference> differences;
  for (std::size_t i = 1; i < values.size(); ++i) {
    differences.push_back(paired_difference(values[i], values.front()));
  }
  correct_by_holm(differences);
  return differences;
}

}  // namespace autoref::experiments
