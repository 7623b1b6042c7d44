#include "experiments/statistics/ratings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/coverage/leagues.hpp"
#include "tools/coverage/measured.hpp"

namespace autoref::coverage {
namespace {

using experiments::Rating;
using RateTeams = std::vector<Rating> (*)(std::vector<experiments::RatedMatchup>);

// Uses fewer trials of the bootstrap, which takes much longer than a profile likelihood.
constexpr int kTrialsPerBootstrap = 5;

// Strengths of teams with moderate differences, where the best team beats the worst in 90 % of
// games. Also strengths with about the differences between the teams in
// results/reference/roundrobin, where the best team practically always beats the worst.
const std::vector<double> kEqual(4, 0.0);
const std::vector<double> kModerate = {1.1, 0.4, -0.4, -1.1};
const std::vector<double> kLarge = {8.1, 3.3, 2.3, 1.0, 0.5, -0.3, -5.2, -9.7};

// Skills of Poisson teams that give similar results.
const std::vector<double> kModerateSkills = {0.3, 0.1, -0.1, -0.3};
const std::vector<double> kLargeSkills = {1.5, 0.55, 0.4, 0.15, 0, 0, -1.2, -2.2};

// The fraction of draws between equal teams: a quarter (as between our teams), or a half, the most
// that dispersion() corrects for.
constexpr double kQuarter = 0.5;
constexpr double kHalf = 1;

// The coverage that the intervals promise, and the cases in which they fall short; see
// docs/explanations/statistics.md.
struct Bounds {
  double least = 0.90;
  double most = 0.985;
};

// The number of round robins in which each team's interval contained its true rating.
struct Held {
  std::vector<int> times;  // counts by team
  int open = 0;            // number of one-sided intervals
  int missing = 0;         // number of teams without an interval
};

void add(Held& held, const std::vector<Rating>& ratings, const std::vector<double>& truth) {
  for (std::size_t i = 0; i < ratings.size(); ++i) {
    const std::optional<experiments::Interval>& interval = ratings[i].interval;
    held.missing += interval ? 0 : 1;
    if (!interval) continue;
    held.open += std::isinf(interval->low) || std::isinf(interval->high) ? 1 : 0;
    held.times[i] += interval->low <= truth[i] && truth[i] <= interval->high ? 1 : 0;
  }
}

Measured summary_of(const Held& held, const std::string& what, int trials, const Bounds& bounds) {
  const auto share = [trials](double count) { return count / trials; };
  const double teams = static_cast<double>(held.times.size());
  const auto [least, most] = std::minmax_element(held.times.begin(), held.times.end());
  const int sum = std::accumulate(held.times.begin(), held.times.end(), 0);
  return {what, share(sum / teams), bounds.least, bounds.most,
          fmt::format("by team {:.3f} to {:.3f}, one end {:.3f}, none {:.3f}", share(*least),
                      share(*most), share(held.open / teams), share(held.missing / teams))};
}

Measured measure(RateTeams rate, const League& league, const std::vector<double>& truth, int pairs,
                 int trials, const Bounds& bounds) {
  RandomStream random(static_cast<std::uint64_t>(pairs));
  Held held{std::vector<int>(truth.size(), 0), 0, 0};
  for (int i = 0; i < trials; ++i) add(held, rate(play_round_robin(league, pairs, random)), truth);
  const char* what = rate == experiments::goal_ratings_of ? "goal rating" : "Bradley-Terry";
  return summary_of(held, fmt::format("{}, {}, pairs {}", what, league.name, pairs), trials,
                    bounds);
}

Measured measure_strengths(const League& league, int pairs, int trials, const Bounds& bounds = {}) {
  return measure(experiments::bradley_terry_ratings_of, league, league.strengths, pairs, trials,
                 bounds);
}

// With five pairs, the percentiles of the bootstrap are too narrow.
Measured measure_goals(const League& league, int pairs, int trials) {
  const Bounds bounds{pairs == static_cast<int>(experiments::kFewestResampled) ? 0.84 : 0.90,
                      0.985};
  return measure(experiments::goal_ratings_of, league, league.goals, pairs,
                 trials / kTrialsPerBootstrap, bounds);
}

}  // namespace

std::vector<Measured> rating_coverage(int trials) {
  std::vector<Measured> all;
  const std::vector<League> poisson = {
      poisson_league("Poisson, 4 equal teams", kEqual),
      poisson_league("Poisson, 4 teams, moderate", kModerateSkills),
      poisson_league("Poisson, 8 teams, large", kLargeSkills)};
  std::vector<League> leagues = {model_league("model, 4 equal teams", kEqual, kQuarter),
                                 model_league("model, 4 teams, moderate", kModerate, kQuarter),
                                 model_league("model, 8 teams, large", kLarge, kQuarter)};
  leagues.insert(leagues.end(), poisson.begin(), poisson.end());
  for (const League& league : leagues) {
    for (const int pairs : {1, 5, 10, 30}) {
      all.push_back(measure_strengths(league, pairs, trials));
    }
  }
  // A case with many draws. For teams that almost always win or lose, the dispersion overestimates
  // them.
  const League drawn = model_league("half drawn, 8 teams, large", kLarge, kHalf);
  for (const int pairs : {5, 30}) {
    all.push_back(measure_strengths(drawn, pairs, trials, {.least = 0.86}));
  }
  // A case with few games, which have only a few possible results.
  const League two = model_league("model, 2 equal teams", {0, 0}, kQuarter);
  for (const int pairs : {1, 5}) all.push_back(measure_strengths(two, pairs, trials, {.most = 1}));
  for (const League& league : poisson) {
    for (const int pairs : {5, 10, 30}) all.push_back(measure_goals(league, pairs, trials));
  }
  return all;
}

}  // namespace autoref::coverage
