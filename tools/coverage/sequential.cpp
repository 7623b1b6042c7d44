#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/statistics/sequential_test.hpp"
#include "tools/coverage/goals.hpp"
#include "tools/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

using experiments::SequentialState;
using experiments::SequentialTest;
using experiments::Verdict;

constexpr double kLeads[] = {0.05, 0.1, 0.2, 0.5, 1};  // d1, in goals per game; d0 is 0
constexpr double kSpreads[] = {0.2, 0.5, 1, 2, 4};     // standard deviations of a game's difference
constexpr int kMostPairs = 9999;
// The errors may exceed the promised rates by this factor, plus the standard errors of the
// proportion.
constexpr double kAllowance = 1.2;
// Goals that come in bursts skew the differences.
constexpr double kUnevenAllowance = 1.4;
constexpr double kVeryUnevenAllowance = 2;
constexpr double kStandardErrors = 2;
// Tests that need more pairs than this are run less often.
constexpr double kManyPairs = 1000;

// A sequential test in a case in which the true lead equals one of its hypotheses.
struct Trial {
  SequentialTest test;
  double sd = 0;  // standard deviation of a game's goal difference
  Goals goals;
  double allowance = kAllowance;
};

SequentialState run_until_decided(const SequentialTest& test, const Pairs& next,
                                  RandomStream& random) {
  std::vector<double> differences;
  SequentialState state;
  while (state.verdict == Verdict::kGoOn) {  // the loop ends at test.max_pairs at the latest
    const std::size_t more = std::max<std::size_t>(differences.size(), test.min_pairs);
    for (std::size_t i = 0; i < more; ++i) differences.push_back(next(random));
    state = experiments::decided_by(test, differences);
  }
  return state;
}

// About as many pairs as the test needs if the spread is known: twice the bounds divided by the
// information from one pair.
double pairs_needed(const Trial& trial) {
  const double lead = trial.test.d1 - trial.test.d0;
  return 2 * experiments::bound_of_d1(trial.test) * trial.sd * trial.sd / 2 / (lead * lead);
}

struct Errors {
  int tests = 0;
  int wrong = 0;
  int undecided = 0;
  double pairs = 0;
};

Errors errors_of(const Trial& trial, double truth, Verdict wrong, int trials) {
  RandomStream random(1945);
  const Pairs next = trial.goals.pairs(truth, trial.sd);
  Errors errors;
  errors.tests =
      static_cast<int>(std::ceil(trials * std::min(1.0, kManyPairs / pairs_needed(trial))));
  for (int i = 0; i < errors.tests; ++i) {
    const SequentialState state = run_until_decided(trial.test, next, random);
    errors.wrong += state.verdict == wrong ? 1 : 0;
    errors.undecided += state.verdict == Verdict::kUndecided ? 1 : 0;
    errors.pairs += state.pairs;
  }
  return errors;
}

Measured measured(const Trial& trial, bool is_d1_true, int trials) {
  const SequentialTest& test = trial.test;
  const double truth = is_d1_true ? test.d1 : test.d0;
  const double promised = is_d1_true ? test.beta : test.alpha;
  const Errors errors =
      errors_of(trial, truth, is_d1_true ? Verdict::kAcceptD0 : Verdict::kAcceptD1, trials);
  const auto share = [&errors](double count) { return count / errors.tests; };
  const double error = std::sqrt(promised * (1 - promised) / errors.tests);
  return {fmt::format("{}, sd {:.2f}, d0 {}, d1 {}, true {}", trial.goals.name, trial.sd, test.d0,
                      test.d1, truth),
          share(errors.wrong), 0, trial.allowance * promised + kStandardErrors * error,
          fmt::format("undecided {:.4f}, mean {:.1f} pairs, {} tests", share(errors.undecided),
                      share(errors.pairs), errors.tests)};
}

bool is_possible(const Trial& trial) {
  const bool has_goals = trial.goals.pairs != normal_pairs;
  const double most = std::max(std::abs(trial.test.d0), std::abs(trial.test.d1));
  return pairs_needed(trial) < kMostPairs && (!has_goals || trial.sd * trial.sd >= most);
}

std::vector<Trial> leads_and_spreads() {
  std::vector<Trial> all;
  for (const double lead : kLeads) {
    const SequentialTest test{.d0 = 0, .d1 = lead, .max_pairs = kMostPairs};
    for (const double sd : kSpreads) {
      all.push_back({test, sd, kNormal});
      all.push_back({test, sd, kPoisson});
    }
    // Cases with as few goals as the lead allows, or a few more, where the differences are most
    // skewed.
    for (const double more : {1.0, 1.5, 2.0}) {
      all.push_back({test, more * std::sqrt(lead), kPoisson});
    }
    all.push_back({test, 2, kUneven, kUnevenAllowance});
  }
  return all;
}

std::vector<Trial> other_settings() {
  return {{{.d0 = -0.1, .d1 = 0.1, .max_pairs = kMostPairs}, 0.5, kPoisson},
          {{.d0 = 0.5, .d1 = 0.7, .max_pairs = kMostPairs}, 1, kPoisson},
          {{.d0 = 0, .d1 = -0.2, .max_pairs = kMostPairs}, 0.7, kPoisson},
          {{.d0 = 0, .d1 = 0.5, .alpha = 0.01, .beta = 0.1, .max_pairs = kMostPairs}, 1, kPoisson},
          {{.d0 = 0, .d1 = 1, .min_pairs = 2, .max_pairs = kMostPairs}, 2, kPoisson},
          {{.d0 = 0, .d1 = 0.5, .max_pairs = kMostPairs}, 2, kVeryUneven, kVeryUnevenAllowance}};
}

}  // namespace

std::vector<Measured> sequential_errors(int trials) {
  std::vector<Trial> all = leads_and_spreads();
  for (const Trial& other : other_settings()) all.push_back(other);
  std::vector<Measured> lines;
  for (const Trial& trial : all) {
    if (!is_possible(trial)) continue;
    for (const bool is_d1_true : {false, true})
      lines.push_back(measured(trial, is_d1_true, trials));
  }
  return lines;
}

}  // namespace autoref::coverage
