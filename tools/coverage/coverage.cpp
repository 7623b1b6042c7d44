// Checks the statistics on simulated games with known parameters: the coverage of the intervals and
// the error rates of the sequential test.
//
//     coverage [TRIALS]      default: 20000
//
// The exit code is 1 if a proportion is outside its bounds, and 2 for an invalid argument.
#include <fmt/format.h>

#include "io/words.hpp"
#include "tools/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

constexpr int kTrials = 20000;
constexpr int kFewestTrials = 1000;  // with fewer, proportions leave their bounds by chance
constexpr int kMostTrials = 10'000'000;
// Uses fewer trials, since rating a round robin takes a long time.
constexpr int kTrialsPerRoundRobin = 4;
constexpr int kTrialsPerComparison = 4;  // one comparison takes up to thousands of games

// The number of results outside their bounds.
int print(const std::vector<Measured>& lines) {
  int bad = 0;
  for (const Measured& line : lines) {
    fmt::print("{:<4} {:.4f}  ({} to {})  {:<52} {}\n", line.is_good() ? "ok" : "BAD", line.share,
               line.least, line.most, line.what, line.remark);
    bad += line.is_good() ? 0 : 1;
  }
  return bad;
}

int measure(int trials) {
  fmt::print("Coverage of 95 % intervals in {} trials:\n", trials);
  int bad = print(interval_coverage(trials));
  const int round_robins = trials / kTrialsPerRoundRobin;
  fmt::print("\nCoverage for ratings, {} round robins:\n", round_robins);
  bad += print(rating_coverage(round_robins));
  fmt::print("\nError rates of the sequential test, at most {} tests each:\n", trials);
  bad += print(sequential_errors(trials));
  const int comparisons = trials / kTrialsPerComparison;
  fmt::print("\nError rates of comparisons, {} each:\n", comparisons);
  bad += print(comparison_errors(comparisons));
  fmt::print("\n{} outside the bounds\n", bad);
  return bad == 0 ? 0 : 1;
}

}  // namespace
}  // namespace autoref::coverage

int main(int argc, char** argv) {
  using namespace autoref::coverage;
  const auto trials = argc < 2 ? kTrials : autoref::io::whole_number_in(argv[1]).value_or(0);
  if (argc > 2 || trials < kFewestTrials || trials > kMostTrials) {
    fmt::print(stderr, "coverage: expected a number of trials from {} to {}\n", kFewestTrials,
               kMostTrials);
    return 2;
  }
  return measure(trials);
}
