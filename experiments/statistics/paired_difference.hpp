// Differences between an experiment's values and its baseline, and their correction for multiple
// comparisons. Pairs with the same number use the same seeds for every value, so values are
// compared pair by pair.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// Holm's step-down correction for multiple comparisons (Holm, A simple sequentially rejective
// multiple test procedure, Scand. J. Stat. 6, 1979). The correction is needed because some tests
// look significant by chance, and the more tests are made, the more of them do. Returns the
// adjusted p values in the order of `p`. Rejecting hypotheses with an adjusted p value of at most
// 0.05 leads to a false rejection in at most 5 % of experiments, regardless of how the tests depend
// on each other.
std::vector<double> holm(std::span<const double> p);

// The largest corrected p value of a difference that tables mark.
inline constexpr double kSignificant = 0.05;

// Sets `p_holm` of the tests that have a `p`, corrected over all of them. `test` returns an item's
// test, if the item is not a test itself.
template <typename Item, typename Test = std::identity>
void correct_by_holm(std::vector<Item>& items, Test test = {}) {
  std::vector<double> p;
  for (Item& item : items)
    if (const auto& its_p = std::invoke(test, item).p) p.push_back(*its_p);
  const std::vector<double> corrected = holm(p);
  auto next = corrected.begin();
  for (Item& item : items)
    if (std::invoke(test, item).p) std::invoke(test, item).p_holm = *next++;
}

// A value of each pair, by pair number: usually the mean goal difference over its two legs.
using DifferenceByPair = std::map<int, double>;

// The goal differences of a value's pairs minus those of the baseline's pairs, over the pair
// numbers that both have.
struct PairedDifference {
  std::size_t pairs = 0;
  std::optional<double> mean;  // nullopt if there are no pairs
  // Student's t interval of the mean; nullopt if there is only one pair.
  std::optional<Interval> interval;
  // Two-sided p value of the paired t test of "no difference"; nullopt for a single pair, or if all
  // pairs have the same difference. `p_holm` is its Holm correction over all values with a p.
  std::optional<double> p;
  std::optional<double> p_holm;
  // Cohen's d_z: the mean divided by the standard deviation of these differences (not of the
  // scores; Lakens, Front. Psychol. 4:863, 2013). nullopt if `p` is nullopt.
  std::optional<double> effect_size;
};

// Compares a value with the baseline. Does not set p_holm.
PairedDifference paired_difference(const DifferenceByPair& value, const DifferenceByPair& baseline);

// Compares each value with the first one, the baseline. The result has no entry for the baseline:
// entry i belongs to value i + 1. Sets p_holm.
std::vector<PairedDifference> differences_from_baseline(std::span<const DifferenceByPair> values);

}  // namespace autoref::experiments
