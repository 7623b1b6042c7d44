// Several tests at once: the more comparisons, the more of them look remarkable by chance.
#pragma once

#include <span>
#include <vector>

namespace autoref::runner {

// Holm's step-down correction (Holm, A simple sequentially rejective multiple test procedure,
// Scand. J. Stat. 6, 1979): the p values as they count among all of `p`, in the same order. Calling
// remarkable what is at most 0.05 here calls anything so wrongly in at most 5 % of experiments,
// however the tests depend on each other.
std::vector<double> holm(std::span<const double> p);

}  // namespace autoref::runner
