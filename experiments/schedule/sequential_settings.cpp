#include "experiments/schedule/sequential_settings.hpp"

#include <fmt/format.h>

#include "experiments/schedule/schedule.hpp"
#include "game/settings/setting_value.hpp"

namespace autoref::experiments {
namespace {

constexpr Range kErrorRate = {0, 0.49, true};    // alpha + beta must stay below 1
constexpr Range kTestedPairs = {2, kMostPairs};  // a single pair has no variance

}  // namespace

std::vector<game::Setting> settings_of(SequentialTest& test, const std::string& branch,
                                       const ErrorRates& about) {
  return {{branch + ".alpha", &test.alpha, kErrorRate, {}, "", about.alpha},
          {branch + ".beta", &test.beta, kErrorRate, {}, "", about.beta},
          {branch + ".min_pairs",
           &test.min_pairs,
           kTestedPairs,
           {},
           "",
           "minimum number of pairs of legs"},
          {branch + ".max_pairs",
           &test.max_pairs,
           kTestedPairs,
           {},
           "",
           "pairs of legs after which the test ends undecided"}};
}

void check_test(const SequentialTest& test, const std::string& branch) {
  if (test.d0 == test.d1) {
    throw game::SettingError(
        branch + ".d1",
        fmt::format(": must differ from d0, or there is nothing to test; both are {}", test.d1));
  }
  if (test.max_pairs < test.min_pairs) {
    throw game::SettingError(branch + ".max_pairs",
                             fmt::format(": must be at least min_pairs, which is {}; found {}",
                                         test.min_pairs, test.max_pairs));
  }
}

}  // namespace autoref::experiments
