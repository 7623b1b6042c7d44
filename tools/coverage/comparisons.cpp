#include <fmt/format.h>

#include <cmath>

#include "experiments/statistics/anytime_interval.hpp"
#include "tools/coverage/goals.hpp"
#include "tools/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

using experiments::ComparisonState;
using experiments::ComparisonTest;
using experiments::ThreeWayVerdict;

constexpr double kFalseShare = 0.05;    // "better" or "worse" without a difference
constexpr double kMissedLeast = 0.025;  // "no difference" although there is the least that matters
constexpr double kFoundShare = 0.9;     // "better" if there is the least difference that matters
constexpr double kErrorsAllowed = 2;    // standard errors of the proportion

// A comparison of teams whose games have this standard deviation of the goal difference.
struct Compared {
  ComparisonTest test;
  double sd = 0;
  Goals goals;
};

struct Outcomes {
  int comparisons = 0;
  int better = 0;
  int worse = 0;
  int no_difference = 0;
  double pairs = 0;

  double share(int count) const { return static_cast<double>(count) / comparisons; }
  double standard_error(double share) const { return std::sqrt(share * (1 - share) / comparisons); }
};

ComparisonState compare_once(const ComparisonTest& test, const Pairs& next, RandomStream& random) {
  std::vector<double> differences;
  ComparisonState state;
  while (state.verdict == ThreeWayVerdict::kGoOn) {  // ends at test.max_pairs at the latest
    const std::size_t more = std::max<std::size_t>(differences.size() / 2, 20);
    for (std::size_t i = 0; i < more; ++i) differences.push_back(next(random));
    state = experiments::decided_by(test, differences);
  }
  return state;
}

Outcomes outcomes_of(const Compared& compared, double difference, int comparisons) {
  RandomStream random(1976);
  const Pairs next = compared.goals.pairs(difference, compared.sd);
  Outcomes outcomes;
  outcomes.comparisons = comparisons;
  for (int i = 0; i < comparisons; ++i) {
    const ComparisonState state = compare_once(compared.test, next, random);
    outcomes.better += state.verdict == ThreeWayVerdict::kBetter ? 1 : 0;
    outcomes.worse += state.verdict == ThreeWayVerdict::kWorse ? 1 : 0;
    outcomes.no_difference += state.verdict == ThreeWayVerdict::kNotShown ? 1 : 0;
    outcomes.pairs += state.pairs;
  }
  return outcomes;
}

void measure(const Compared& compared, int comparisons, std::vector<Measured>& lines) {
  const double least = compared.test.least;
  const std::string where =
      fmt::format("{}, sd {}, least {}", compared.goals.name, compared.sd, least);
  const auto games = [](const Outcomes& outcomes) {
    return fmt::format("mean {:.0f} games", 2 * outcomes.pairs / outcomes.comparisons);
  };
  const Outcomes equal = outcomes_of(compared, 0, comparisons);
  lines.push_back({where + ": claimed, of 0", equal.share(equal.better + equal.worse), 0,
                   kFalseShare + kErrorsAllowed * equal.standard_error(kFalseShare), games(equal)});
  const Outcomes better = outcomes_of(compared, least, comparisons);
  lines.push_back({fmt::format("{}: found, of {}", where, least), better.share(better.better),
                   kFoundShare - kErrorsAllowed * better.standard_error(kFoundShare), 1,
                   games(better)});
  lines.push_back({fmt::format("{}: denied, of {}", where, least),
                   better.share(better.no_difference), 0,
                   kMissedLeast + kErrorsAllowed * better.standard_error(kMissedLeast), ""});
}

}  // namespace

std::vector<Measured> comparison_errors(int trials) {
  const ComparisonTest usual;  // 600 games between two teams
  std::vector<Compared> all;
  for (const Goals& goals : {kNormal, kPoisson, kUneven}) {
    all.push_back({usual, 1, goals});
    all.push_back({usual, 1.6, goals});
    all.push_back({{.least = 0.5, .max_pairs = 400}, 2.5, goals});
    all.push_back({{.least = 1, .max_pairs = 400}, 4, goals});
    all.push_back({{.least = 0.1, .max_pairs = 2500}, 1.6, goals});
  }
  std::vector<Measured> lines;
  for (const Compared& compared : all) measure(compared, trials, lines);
  return lines;
}

}  // namespace autoref::coverage
