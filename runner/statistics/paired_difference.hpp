// How much the values of an experiment differ from its baseline. Pairs of one number have the same
// seeds at every value, so that values are compared pair by pair.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runner/statistics/interval.hpp"

namespace autoref::runner {

// By pair number: mean goal difference over the pair's two legs.
using DifferenceByPair = std::map<int, double>;

// A value's pair differences minus the baseline's, over the pair numbers that both have.
struct PairedDifference {
  std::size_t pairs = 0;
  std::optional<double> mean;        // none without pairs
  std::optional<Interval> interval;  // Student's, of the mean; none for a single pair
  // Two-sided, of the paired t test of "no difference"; none for a single pair, or where every pair
  // differs by the same. `p_holm` is Holm's correction of it over all values with a p.
  std::optional<double> p;
  std::optional<double> p_holm;
  // Cohen's d_z: the mean in standard deviations of these differences themselves (Lakens, Front.
  // Psychol. 4:863, 2013), not of the scores; none where `p` is none.
  std::optional<double> effect_size;
};

// Without p_holm.
PairedDifference paired_difference(const DifferenceByPair& value, const DifferenceByPair& baseline);

// Of each value from the first one, which is the baseline and has no entry: entry i is of value
// i + 1.
std::vector<PairedDifference> differences_from_baseline(std::span<const DifferenceByPair> values);

}  // namespace autoref::runner
