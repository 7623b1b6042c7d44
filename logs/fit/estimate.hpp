// A number estimated from a recorded game, with its interval.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace autoref::logs {

// An estimate with its 95 % confidence interval; the unit is that of the parameter.
struct Estimated {
  double value = 0;
  double low = 0;
  double high = 0;
};

// The estimate of one parameter. `number` is nullopt if the log shows too little of it.
struct Estimate {
  std::int64_t episodes = 0;  // number of episodes, or of other things seen, behind the estimate
  std::optional<Estimated> number;
};

// An estimate from the groups whose indices are given; a group may be given more than once. Returns
// nullopt if these groups show too little.
using GroupEstimator = std::function<std::optional<double>(std::span<const std::size_t> groups)>;

// Estimates from all of groups 0 to `groups` - 1. The interval is the bootstrap's: the 2.5th and
// 97.5th percentile of estimates from as many groups drawn at random with replacement, always the
// same ones. As these percentiles do not include systematic errors, each half of the interval is
// widened to the root of the sum of its square and that of `systematic` times the value. Without a
// result if there are fewer than `enough` groups, or if `estimator` returns nullopt for all of them
// or for more than a tenth of the draws.
std::optional<Estimated> bootstrap_estimate(std::size_t groups, std::size_t enough,
                                            double systematic, const GroupEstimator& estimator,
                                            int draws = 200);

// The same for several numbers that are estimated together, such as those of one likelihood:
// element i of the result is element i of what `estimator` returns, widened by `systematic[i]`.
using GroupEstimators =
    std::function<std::optional<std::vector<double>>(std::span<const std::size_t> groups)>;
std::optional<std::vector<Estimated>> bootstrap_estimates(std::size_t groups, std::size_t enough,
                                                          const std::vector<double>& systematic,
                                                          const GroupEstimators& estimator,
                                                          int draws = 200);

// The elements of `values` at `indices`.
template <typename Value>
std::vector<Value> elements_at(const std::vector<Value>& values,
                               std::span<const std::size_t> indices) {
  std::vector<Value> result;
  result.reserve(indices.size());
  for (const std::size_t i : indices) result.push_back(values[i]);
  return result;
}

// The median of `values`, which must not be empty. Element i counts `weights[i]` times.
double weighted_median(std::span<const double> values, std::span<const double> weights);
double median(std::vector<double> values);

// The median difference between two values that follow each other; there must be at least two.
double median_step(std::span<const double> values);

// The value below which a share `quantile` of `values` lies, interpolated; `values` must not be
// empty.
double quantile(std::vector<double> values, double quantile);

// A value and its standard deviation.
struct Measured {
  double value = 0;
  double deviation = 0;
};

// The mean of `values`, weighted by 1 / (deviation^2 + spread^2), without those that are more than
// three such deviations away. It starts from the weighted median. `values` must not be empty.
double robust_mean(std::span<const Measured> values, double spread);

}  // namespace autoref::logs
