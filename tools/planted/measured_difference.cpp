#include "tools/planted/measured_difference.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "experiments/statistics/anytime_interval.hpp"
#include "experiments/statistics/ratings.hpp"
#include "experiments/statistics/sample.hpp"
#include "experiments/statistics/sample_size.hpp"
#include "soccer/random.hpp"

namespace autoref::tools {
namespace {

using Sample = std::vector<double>;

constexpr int kLegs = 2;
constexpr std::uint64_t kStreamKey = 1979;

// So small that it neither ends a decision early nor widens its intervals.
constexpr double kLeastDifference = 1e-6;

std::size_t any_below(std::size_t n, RandomStream& random) {
  return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(n)), n - 1);
}

void shuffle(Sample& sample, RandomStream& random) {
  for (std::size_t i = sample.size(); i > 1; --i)
    std::swap(sample[i - 1], sample[any_below(i, random)]);
}

OrderedDecisions decisions_of(Sample differences, double mean_of_goals) {
  using experiments::ThreeWayVerdict;
  const ThreeWayVerdict right =
      mean_of_goals > 0 ? ThreeWayVerdict::kBetter : ThreeWayVerdict::kWorse;
  const auto pairs = static_cast<int>(differences.size());
  const experiments::ComparisonTest test{.least = kLeastDifference, .max_pairs = pairs};
  constexpr double kShare = 1.0 / experiments::kResamples;
  OrderedDecisions decisions;
  std::vector<double> games;
  games.reserve(experiments::kResamples);
  RandomStream random(kStreamKey);
  for (int i = 0; i < experiments::kResamples; ++i) {
    shuffle(differences, random);
    const experiments::ComparisonState state = experiments::decided_by(test, differences);
    const bool is_decided =
        state.verdict == ThreeWayVerdict::kBetter || state.verdict == ThreeWayVerdict::kWorse;
    if (is_decided) (state.verdict == right ? decisions.right : decisions.wrong) += kShare;
    games.push_back(kLegs * (is_decided ? state.pairs : pairs + 1));
  }
  const auto median = static_cast<int>(experiments::median(games));
  if (median <= kLegs * pairs) decisions.median_games = median;
  return decisions;
}

RelativeGames relative_games_of(const Sample& differences, const Sample& goals) {
  Sample factors;
  factors.reserve(experiments::kResamples);
  RandomStream random(kStreamKey);
  Sample drawn(differences.size());
  Sample drawn_goals(goals.size());
  for (int i = 0; i < experiments::kResamples; ++i) {
    for (std::size_t pair = 0; pair < drawn.size(); ++pair) {
      const std::size_t any = any_below(drawn.size(), random);
      drawn[pair] = differences[any];
      drawn_goals[pair] = goals[any];
    }
    factors.push_back(relative_games(drawn, drawn_goals));
  }
  return {relative_games(differences, goals),
          {experiments::quantile_of(factors, experiments::kMissedShare / 2),
           experiments::quantile_of(factors, 1 - experiments::kMissedShare / 2)}};
}

double squared_sd(std::span<const double> sample) {
  const double sd = experiments::standard_deviation(sample).value();
  return sd * sd;
}

std::optional<double> correlation_of(const Sample& x, const Sample& y) {
  const double variances = squared_sd(x) * squared_sd(y);
  const std::optional<double> slope = experiments::slope_of(x, y);
  if (!slope || !(variances > 0)) return std::nullopt;
  return *slope * std::sqrt(squared_sd(x) / squared_sd(y));
}

Sample minus(const Sample& sample, const Sample& other) {
  Sample differences;
  differences.reserve(sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i) differences.push_back(sample[i] - other[i]);
  return differences;
}

std::optional<int> games_of(const MeasuredDifference& measured, double mean_of_goals) {
  if (!(measured.sd > 0) || !(measured.mean * mean_of_goals > 0)) return std::nullopt;
  // The sample size assumes independent legs, so that a pair's sd is that of a game over sqrt(2).
  return experiments::games_needed(
      {.delta = measured.mean, .sd = std::numbers::sqrt2 * measured.sd}, kPower);
}

MeasuredDifference measured_difference(const MeasuredPairs& pairs, const Sample& goals) {
  const Sample& differences = pairs.differences;
  const Sample minus_goals = minus(differences, goals);
  const double mean_of_goals = experiments::mean(goals);
  MeasuredDifference measured;
  measured.measure = pairs.measure;
  measured.mean = experiments::mean(differences);
  measured.interval = experiments::mean_interval(differences);
  measured.sd = experiments::standard_deviation(differences).value();
  measured.correlation = correlation_of(differences, goals);
  measured.minus_goals = experiments::mean(minus_goals);
  measured.minus_goals_interval = experiments::mean_interval(minus_goals);
  measured.games = games_of(measured, mean_of_goals);
  measured.relative = relative_games_of(differences, goals);
  measured.relative_with_equal_means = squared_sd(differences) / squared_sd(goals);
  measured.decisions = decisions_of(differences, mean_of_goals);
  return measured;
}

}  // namespace

std::vector<MeasuredDifference> measured_differences(const std::vector<MeasuredPairs>& measures) {
  std::vector<MeasuredDifference> all;
  all.reserve(measures.size());
  for (const MeasuredPairs& pairs : measures) {
    assert(pairs.differences.size() == measures.front().differences.size());
    all.push_back(measured_difference(pairs, measures.front().differences));
  }
  return all;
}

double relative_games(std::span<const double> differences, std::span<const double> goals) {
  const double mean = experiments::mean(differences);
  const double mean_of_goals = experiments::mean(goals);
  if (!(mean * mean_of_goals > 0)) return kMostRelativeGames;
  const double ratio = mean_of_goals / mean;
  const double factor = squared_sd(differences) / squared_sd(goals) * ratio * ratio;
  return factor < kMostRelativeGames ? factor : kMostRelativeGames;
}

}  // namespace autoref::tools
