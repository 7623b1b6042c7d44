#include "runner/experiments/sprt_settings.hpp"

#include <fmt/format.h>

#include "runner/settings/setting_error.hpp"

namespace autoref::runner {
namespace {

constexpr Range kGoals = {-50, 50};
constexpr Range kErrorRate = {0, 0.49, true};  // alpha + beta must stay below 1
constexpr Range kSprtPairs = {2, 9999};        // a single pair has no variance

}  // namespace

std::vector<Setting> settings_of(SequentialTest& test) {
  const char* const goals = "goals per game";
  return {
      {"sprt.d0", &test.d0, kGoals, {}, goals, "mean goal difference under the null hypothesis"},
      {"sprt.d1", &test.d1, kGoals, {}, goals, "mean goal difference under the alternative"},
      {"sprt.alpha", &test.alpha, kErrorRate, {}, "", "probability of accepting d1 if d0 is true"},
      {"sprt.beta", &test.beta, kErrorRate, {}, "", "probability of accepting d0 if d1 is true"},
      {"sprt.min_pairs", &test.min_pairs, kSprtPairs, {}, "", "minimum number of pairs of legs"},
      {"sprt.max_pairs",
       &test.max_pairs,
       kSprtPairs,
       {},
       "",
       "pairs of legs after which the test ends undecided"}};
}

void check_test(const SequentialTest& test) {
  if (test.d0 == test.d1) {
    throw SettingError(
        "sprt.d1",
        fmt::format(": must differ from d0, or there is nothing to test; both are {}", test.d1));
  }
  if (test.max_pairs < test.min_pairs) {
    throw SettingError("sprt.max_pairs",
                       fmt::format(": must be at least min_pairs, which is {}; found {}",
                                   test.min_pairs, test.max_pairs));
  }
}

}  // namespace autoref::runner
