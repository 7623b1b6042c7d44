#include "experiments/statistics/three_way_test.hpp"

#include <algorithm>
#include <cassert>

namespace autoref::experiments {

ThreeWayState compared(const SequentialTest& test, std::span<const double> pair_differences) {
  assert(test.d0 == 0 && test.d1 > 0);
  SequentialTest downwards = test;
  downwards.d1 = -test.d1;
  const SequentialState better = decided_by(test, pair_differences);
  const SequentialState worse = decided_by(downwards, pair_differences);
  const bool is_better = better.verdict == Verdict::kAcceptD1;
  const bool is_worse = worse.verdict == Verdict::kAcceptD1;
  if (is_better && (!is_worse || better.pairs <= worse.pairs)) {
    return {ThreeWayVerdict::kBetter, better.pairs};
  }
  if (is_worse) return {ThreeWayVerdict::kWorse, worse.pairs};
  const int pairs = std::max(better.pairs, worse.pairs);
  const bool is_open = better.verdict == Verdict::kGoOn || worse.verdict == Verdict::kGoOn;
  if (is_open) return {ThreeWayVerdict::kGoOn, pairs};
  const bool is_zero = better.verdict == Verdict::kAcceptD0 && worse.verdict == Verdict::kAcceptD0;
  return {is_zero ? ThreeWayVerdict::kNotShown : ThreeWayVerdict::kUndecided, pairs};
}

}  // namespace autoref::experiments
