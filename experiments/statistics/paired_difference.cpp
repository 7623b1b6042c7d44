#include "experiments/statistics/paired_difference.hpp"

#include "experiments/statistics/holm.hpp"
#include "experiments/statistics/mean_interval.hpp"
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

void correct_by_holm(std::vector<PairedDifference>& differences) {
  std::vector<double> p;
  for (const PairedDifference& difference : differences) {
    if (difference.p) p.push_back(*difference.p);
  }
  const std::vector<double> corrected = holm(p);
  auto next = corrected.begin();
  for (PairedDifference& difference : differences) {
    if (difference.p) difference.p_holm = *next++;
  }
}

}  // namespace

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
