// Correction for multiple comparisons: the more tests are made, the more of them look significant
// by chance.
#pragma once

#include <span>
#include <vector>

namespace autoref::experiments {

// Holm's step-down correction (Holm, A simple sequentially rejective multiple test procedure,
// Scand. J. Stat. 6, 1979). Returns the adjusted p values in the order of `p`. Rejecting hypotheses
// with an adjusted p value of at most 0.05 makes any false rejection in at most 5 % of experiments,
// however the tests depend on each other.
std::vector<double> holm(std::span<const double> p);

}  // namespace autoref::experiments
