#include <fmt/format.h>

#include <functional>
#include <numbers>

#include "runner/statistics/sequential_test.hpp"
#include "tests/coverage/goals.hpp"
#include "tests/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

using runner::SequentialState;
using runner::SequentialTest;
using runner::Verdict;

constexpr SequentialTest kTest;  // d0 = 0, d1 = 1, alpha = beta = 0.05, 10 to 200 pairs
constexpr double kMostErrors = 0.06;

// Draws the mean goal difference of the next pair of legs.
using Pairs = std::function<double(RandomStream&)>;

// Pairs whose legs are independent and each have the standard deviation `sd`.
Pairs normal_pairs(double mean, double sd) {
  return [=](RandomStream& random) { return mean + sd / std::numbers::sqrt2 * random.normal(); };
}

// The variance of a game's difference is the sum of both teams' expected goals.
Pairs poisson_pairs(double mean, double sd) {
  const Means means{(sd * sd + mean) / 2, (sd * sd - mean) / 2};
  return [=](RandomStream& random) { return pair_differences(play(means, 2, random)).front(); };
}

SequentialState test_until_decided(const Pairs& next, RandomStream& random) {
  std::vector<double> differences;
  SequentialState state;
  while (state.verdict == Verdict::kGoOn) {  // ends at kTest.max_pairs
    for (int i = 0; i < kTest.min_pairs; ++i) differences.push_back(next(random));
    state = runner::decided_by(kTest, differences);
  }
  return state;
}

Measured errors_of(const std::string& what, const Pairs& next, Verdict wrong, int trials) {
  RandomStream random(1945);
  int errors = 0;
  int undecided = 0;
  double pairs = 0;
  for (int i = 0; i < trials; ++i) {
    const SequentialState state = test_until_decided(next, random);
    errors += state.verdict == wrong ? 1 : 0;
    undecided += state.verdict == Verdict::kUndecided ? 1 : 0;
    pairs += state.pairs;
  }
  const auto share = [trials](double count) { return count / trials; };
  return {what, share(errors), 0, kMostErrors,
          fmt::format("undecided {:.4f}, mean {:.1f} pairs", share(undecided), share(pairs))};
}

}  // namespace

std::vector<Measured> sequential_errors(int trials) {
  std::vector<Measured> all;
  for (const double sd : {2.0, 4.0}) {
    for (const double truth : {kTest.d0, kTest.d1}) {
      const Verdict wrong = truth == kTest.d0 ? Verdict::kAcceptD1 : Verdict::kAcceptD0;
      const std::string where = fmt::format("sd {}, true difference {}", sd, truth);
      all.push_back(
          errors_of("sequential, normal, " + where, normal_pairs(truth, sd), wrong, trials));
      all.push_back(
          errors_of("sequential, Poisson, " + where, poisson_pairs(truth, sd), wrong, trials));
    }
  }
  return all;
}

}  // namespace autoref::coverage
