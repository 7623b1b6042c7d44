// Rounds of benchmarks that print an interval.
#pragma once

namespace autoref::runner {

// The fewest with a 95 % interval of the median (statistics/median_interval.hpp).
inline constexpr int kFewestRounds = 6;
inline constexpr int kDefaultRounds = 12;

}  // namespace autoref::runner
