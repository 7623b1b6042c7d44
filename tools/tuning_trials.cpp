// Measures how many games the optimisers need on functions with a known optimum and noise similar
// to that of games, and how often the test of the result errs. docs/tuning.md shows its output.
//
//     tuning_trials [SEEDS]      default: 200
#include <fmt/format.h>

#include "experiments/statistics/anytime_interval.hpp"
#include "experiments/statistics/interval.hpp"
#include "io/words.hpp"
#include "tests/experiments/tune/noisy_search.hpp"

namespace autoref::tools {
namespace {

constexpr int kDefaultSeeds = 200;
constexpr int kMostSeeds = 100000;
constexpr int kBudgets[] = {500, 1000, 2000, 4000};  // games

struct Kind {
  const char* name;
  experiments::Method method;
  int pairs;
  bool against_itself;
};

constexpr Kind kSearches[] = {{"SPSA against others", experiments::Method::kSpsa, 4, false},
                              {"SPSA against itself", experiments::Method::kSpsa, 4, true},
                              {"CMA-ES against others", experiments::Method::kCmaEs, 8, false}};

void print_row(const char* name, const experiments::Loss& loss, int dimensions, const Kind& kind,
               int seeds) {
  std::string line = fmt::format("| {} {} | {} |", name, dimensions, kind.name);
  for (const int games : kBudgets) {
    experiments::NoisySearch search{
        {kind.method}, dimensions, kind.pairs, 0.2, kind.against_itself};
    search.search.iterations = games / search.games();
    const double mean = search.search.iterations < 3 ? -1 : search.mean_loss(loss, seeds);
    line += mean < 0 ? " - |" : fmt::format(" {:.2f} |", mean);
  }
  fmt::print("{}\n", line);
}

void print_table(int seeds) {
  fmt::print("| function, parameters | search |");
  for (const int games : kBudgets) fmt::print(" {} games |", games);
  fmt::print("\n|---|---|---|---|---|---|\n");
  for (const auto& [name, loss] :
       {std::pair<const char*, experiments::Loss>{"bowl", experiments::bowl},
        {"valley", experiments::valley}}) {
    for (const int dimensions : {2, 4, 8}) {
      for (const Kind& kind : kSearches) print_row(name, loss, dimensions, kind, seeds);
    }
  }
}

constexpr experiments::SequentialTest kTest = {.d0 = 0, .d1 = 0.5, .max_pairs = 400};
constexpr double kGainNoise = 1.6;  // standard deviation of a pair's gain, in goals
constexpr int kTestsPerSeed = 25;

struct TestCounts {
  int better = 0;
  int worse = 0;
  int not_shown = 0;  // cases in which no difference was shown, or the test is undecided
  int pairs = 0;
  int missed = 0;             // cases in which anytime_interval() missed the true value
  int missed_by_student = 0;  // cases in which mean_interval() missed the true value
};

bool misses(const std::optional<experiments::Interval>& interval, double gain) {
  return interval && (interval->low > gain || interval->high < gain);
}

void add_test(double gain, std::uint64_t seed, TestCounts& counts) {
  RandomStream random(seed);
  std::vector<double> pairs;
  pairs.reserve(static_cast<std::size_t>(kTest.max_pairs));
  for (int i = 0; i < kTest.max_pairs; ++i) pairs.push_back(gain + kGainNoise * random.normal());
  const experiments::ThreeWayState state = experiments::compared(kTest, pairs);
  pairs.resize(static_cast<std::size_t>(state.pairs));
  const bool is_better = state.verdict == experiments::ThreeWayVerdict::kBetter;
  const bool is_worse = state.verdict == experiments::ThreeWayVerdict::kWorse;
  counts.better += is_better ? 1 : 0;
  counts.worse += is_worse ? 1 : 0;
  counts.not_shown += is_better || is_worse ? 0 : 1;
  counts.pairs += state.pairs;
  counts.missed += misses(experiments::anytime_interval(pairs), gain) ? 1 : 0;
  counts.missed_by_student += misses(experiments::mean_interval(pairs), gain) ? 1 : 0;
}

void print_tests(int tests) {
  fmt::print(
      "\n{} tests each\n\n| true gain | better | worse | not shown | pairs | the interval misses "
      "the "
      "gain | Student's would miss it |\n|---|---|---|---|---|---|---|\n",
      tests);
  for (const double gain : {0.0, 0.25, 0.5, -0.5}) {
    TestCounts counts;
    for (int test = 1; test <= tests; ++test) {
      add_test(gain, static_cast<std::uint64_t>(test), counts);
    }
    const auto percent = [tests](int count) { return 100.0 * count / tests; };
    fmt::print("| {} | {:.1f} % | {:.1f} % | {:.1f} % | {} | {:.1f} % | {:.1f} % |\n", gain,
               percent(counts.better), percent(counts.worse), percent(counts.not_shown),
               counts.pairs / tests, percent(counts.missed), percent(counts.missed_by_student));
  }
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) {
  using namespace autoref::tools;
  const int seeds = argc < 2 ? kDefaultSeeds : autoref::io::whole_number_in(argv[1]).value_or(0);
  if (argc > 2 || seeds < 1 || seeds > kMostSeeds) {
    fmt::print(stderr, "tuning_trials: expected a number of seeds from 1 to {}\n", kMostSeeds);
    return 2;
  }
  print_table(seeds);
  print_tests(kTestsPerSeed * seeds);
}
