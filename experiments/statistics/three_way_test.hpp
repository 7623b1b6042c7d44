// A sequential test with three outcomes: better, worse, or neither shown.
#pragma once

#include <cstdint>
#include <span>

#include "experiments/statistics/sequential_test.hpp"

namespace autoref::experiments {

enum class ThreeWayVerdict : std::uint8_t {
  kGoOn,       // more pairs are needed
  kBetter,     // the mean is nearer to delta than to 0
  kWorse,      // the mean is nearer to -delta than to 0
  kNotShown,   // the mean is nearer to 0 than to either
  kUndecided,  // max_pairs were not enough
};

struct ThreeWayState {
  ThreeWayVerdict verdict = ThreeWayVerdict::kGoOn;
  int pairs = 0;  // that decided it; later ones do not count
};

// Two sequential tests of the same pairs side by side: one of a mean of 0 against `delta`, the
// other of 0 against -`delta`; Sobel and Wald, A sequential decision procedure for choosing one of
// three hypotheses concerning the unknown mean of a normal distribution, Ann. Math. Stat. 20
// (1949). The first of them that rejects 0 decides; "not shown" needs both to accept it. If the
// mean is 0, "better" and "worse" each have a probability of at most alpha; if it is delta,
// "better" has at least 1 - beta (approximately, as for a single test).
//
// `test.d0` must be 0; `test.d1` is delta, above 0.
ThreeWayState compared(const SequentialTest& test, std::span<const double> pair_differences);

}  // namespace autoref::experiments
