#include "logs/fit/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

constexpr std::uint64_t kBootstrapSeed = 95;

std::vector<std::size_t> in_order_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

std::vector<std::size_t> drawn_groups(std::size_t groups, RandomStream& random) {
  std::vector<std::size_t> drawn(groups);
  std::generate(drawn.begin(), drawn.end(), [&] { return random() % groups; });
  return drawn;
}

// `draws`: the values of one parameter in all draws.
Estimated widened(double value, std::vector<double> draws, double systematic) {
  constexpr double kTail = 0.025;
  const double error = systematic * value;
  const double low = quantile(draws, kTail);
  const double high = quantile(std::move(draws), 1 - kTail);
  return {value, value - std::hypot(value - low, error), value + std::hypot(high - value, error)};
}

}  // namespace

std::optional<std::vector<Estimated>> bootstrap_estimates(std::size_t groups, std::size_t enough,
                                                          const std::vector<double>& systematic,
                                                          const GroupEstimators& estimator,
                                                          int draws) {
  if (groups < std::max<std::size_t>(enough, 1)) return std::nullopt;
  std::vector<std::size_t> all(groups);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto values = estimator(all);
  if (!values) return std::nullopt;

  RandomStream random(kBootstrapSeed);
  std::vector<std::vector<double>> drawn(values->size());
  int failed = 0;
  for (int i = 0; i < draws; ++i) {
    if (const auto draw = estimator(drawn_groups(groups, random))) {
      for (std::size_t k = 0; k < drawn.size(); ++k) drawn[k].push_back((*draw)[k]);
    } else {
      ++failed;
    }
  }
  if (failed * 10 > draws) return std::nullopt;
  std::vector<Estimated> result;
  result.reserve(drawn.size());
  for (std::size_t k = 0; k < drawn.size(); ++k)
    result.push_back(widened((*values)[k], std::move(drawn[k]), systematic[k]));
  return result;
}

std::optional<Estimated> bootstrap_estimate(std::size_t groups, std::size_t enough,
                                            double systematic, const GroupEstimator& estimator,
                                            int draws) {
  const auto result = bootstrap_estimates(
      groups, enough, {systematic},
      [&](std::span<const std::size_t> chosen) -> std::optional<std::vector<double>> {
        if (const auto value = estimator(chosen)) return std::vector{*value};
        return std::nullopt;
      },
      draws);
  if (!result) return std::nullopt;
  return result->front();
}

double weighted_median(std::span<const double> values, std::span<const double> weights) {
  const std::vector<std::size_t> order = in_order_of(values);
  const double half = std::accumulate(weights.begin(), weights.end(), 0.0) / 2;
  double sum = 0;
  for (const std::size_t i : order) {
    sum += weights[i];
    if (sum >= half) return values[i];
  }
  return values[order.back()];
}

double quantile(std::vector<double> values, double quantile) {
  const double position = quantile * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(position);
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const double low = values[static_cast<std::size_t>(below)];
  if (static_cast<std::size_t>(below) + 1 == values.size()) return low;
  const double high = *std::min_element(values.begin() + below + 1, values.end());
  return low + (position - static_cast<double>(below)) * (high - low);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double median_step(std::span<const double> values) {
  std::vector<double> steps;
  steps.reserve(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back(values[i] - values[i - 1]);
  return median(std::move(steps));
}

double robust_mean(std::span<const Measured> values, double spread) {
  constexpr int kRounds = 4;
  constexpr double kFarthest = 3;  // in deviations
  std::vector<double> numbers;
  std::vector<double> weights;
  numbers.reserve(values.size());
  weights.reserve(values.size());
  for (const Measured& measured : values) {
    numbers.push_back(measured.value);
    weights.push_back(1 / (measured.deviation * measured.deviation + spread * spread));
  }
  double mean = weighted_median(numbers, weights);
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    double weight = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (std::abs(numbers[i] - mean) * std::sqrt(weights[i]) > kFarthest) continue;
      sum += weights[i] * numbers[i];
      weight += weights[i];
    }
    if (weight == 0) break;
    mean = sum / weight;
  }
  return mean;
}

}  // namespace autoref::logs
