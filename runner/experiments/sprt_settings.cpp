#include "runner/experiments/sprt_settings.hpp"

#include <fmt/format.h>

#include "runner/settings/setting_error.hpp"

namespace autoref::runner {
namespace {

constexpr Range kGoals = {-50, 50};
constexpr Range kErrorRate = {0, 0.49, true};  // both together must stay below 1
constexpr Range kSprtPairs = {2, 9999};        // one pair has no spread

}  // namespace

std::vector<Setting> settings_of(SequentialTest& test) {
  const char* const goals = "goals a game";
  return {
      {"sprt.d0", &test.d0, kGoals, {}, goals, "mean difference that is taken for true at first"},
      {"sprt.d1", &test.d1, kGoals, {}, goals, "mean difference that the games may speak for"},
      {"sprt.alpha", &test.alpha, kErrorRate, {}, "", "how often d1 may be accepted wrongly"},
      {"sprt.beta", &test.beta, kErrorRate, {}, "", "how often d0 may be accepted wrongly"},
      {"sprt.min_pairs", &test.min_pairs, kSprtPairs, {}, "", "pairs of legs before any verdict"},
      {"sprt.max_pairs",
       &test.max_pairs,
       kSprtPairs,
       {},
       "",
       "pairs of legs, then it ends undecided"}};
}

void check_test(const SequentialTest& test) {
  if (test.d0 == test.d1) {
    throw SettingError(
        "sprt.d1",
        fmt::format(": must differ from d0, or there is nothing to tell apart; both are {}",
                    test.d1));
  }
  if (test.max_pairs < test.min_pairs) {
    throw SettingError("sprt.max_pairs",
                       fmt::format(": must be at least min_pairs, which is {}; found {}",
                                   test.min_pairs, test.max_pairs));
  }
}

}  // namespace autoref::runner
