// Logistic regression.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "game/play_counts/chance.hpp"
#include "soccer/geometry.hpp"
#include "tools/fitting/scores.hpp"

namespace autoref::tools {

template <std::size_t kCount>
struct LogisticSample {
  std::array<double, kCount> features{};
  bool has_happened = false;
};

// The variance of every coefficient's normal prior, whose mean is 0. Most features lie between 0
// and 1. A variance of 1 would make the strong coefficients of shots too small; 100 hardly differs
// from 10.
inline constexpr double kPriorVariance = 10;

// The logarithm of the model's posterior density, up to a constant.
template <std::size_t kCount>
double log_posterior(const game::LimitedModel<kCount>& model,
                     const std::vector<LogisticSample<kCount>>& samples) {
  constexpr double kLeast = 1e-12;
  double sum = 0;
  for (const LogisticSample<kCount>& sample : samples) {
    const double p = model.probability(sample.features);
    sum += std::log(std::max(sample.has_happened ? p : 1 - p, kLeast));
  }
  for (const double coefficient : model.coefficients)
    sum -= square(coefficient) / (2 * kPriorVariance);
  return sum;
}

template <std::size_t kCount>
using Coefficients = Eigen::Matrix<double, static_cast<int>(kCount), 1>;

// Newton's step of the coefficients towards the most probable ones, with the expected instead of
// the observed curvature.
template <std::size_t kCount>
Coefficients<kCount> newton_step(const game::LimitedModel<kCount>& model,
                                 const std::vector<LogisticSample<kCount>>& samples) {
  using Matrix = Eigen::Matrix<double, static_cast<int>(kCount), static_cast<int>(kCount)>;
  Coefficients<kCount> gradient = -Coefficients<kCount>(model.coefficients.data()) / kPriorVariance;
  Matrix curvature = Matrix::Identity() / kPriorVariance;
  for (const LogisticSample<kCount>& sample : samples) {
    const Coefficients<kCount> x(sample.features.data());
    // p = upper_limit * share. The derivative of log p or log(1 - p) by the score is
    // (has_happened - p) * slope.
    const double share = game::probability(model.coefficients, sample.features);
    const double p = model.upper_limit * share;
    const double slope = model.upper_limit == 1 ? 1 : (1 - share) / (1 - p);
    gradient += ((sample.has_happened ? 1.0 : 0.0) - p) * slope * x;
    curvature += p * (1 - share) * slope * x * x.transpose();
  }
  return curvature.ldlt().solve(gradient);
}

// The most probable model with the upper limit of `model`, from which the search begins. Throws
// std::runtime_error if it does not converge.
template <std::size_t kCount>
game::LimitedModel<kCount> fit_logistic(const std::vector<LogisticSample<kCount>>& samples,
                                        game::LimitedModel<kCount> model = {}) {
  constexpr int kRounds = 200;
  constexpr double kLastStep = 1e-5;
  double value = log_posterior(model, samples);
  for (int round = 0; round < kRounds; ++round) {
    // The whole step may lead too far.
    for (Coefficients<kCount> step = newton_step(model, samples);; step /= 2) {
      if (step.norm() < kLastStep) return model;
      game::LimitedModel<kCount> next = model;
      Coefficients<kCount>::Map(next.coefficients.data()) += step;
      const double next_value = log_posterior(next, samples);
      if (next_value <= value) continue;
      model = next;
      value = next_value;
      break;
    }
  }
  throw std::runtime_error("the fit of a logistic model does not converge");
}

// The most probable model and upper limit, a multiple of 0.01. The search goes down from 1 and ends
// when the model is e^10 times less probable than the best one so far.
template <std::size_t kCount>
game::LimitedModel<kCount> fit_limited_logistic(
    const std::vector<LogisticSample<kCount>>& samples) {
  constexpr double kLargestDrop = 10;
  game::LimitedModel<kCount> best = fit_logistic(samples);
  double best_value = log_posterior(best, samples);
  game::LimitedModel<kCount> model = best;
  for (int percent = 99; percent > 0; --percent) {
    model.upper_limit = percent / 100.0;
    model = fit_logistic(samples, model);
    const double value = log_posterior(model, samples);
    if (value < best_value - kLargestDrop) break;
    if (value <= best_value) continue;
    best = model;
    best_value = value;
  }
  return best;
}

template <std::size_t kCount>
Predictions predictions_of(const game::LimitedModel<kCount>& model,
                           const std::vector<LogisticSample<kCount>>& samples) {
  Predictions predictions;
  predictions.reserve(samples.size());
  for (const LogisticSample<kCount>& sample : samples)
    predictions.push_back({model.probability(sample.features), sample.has_happened});
  return predictions;
}

}  // namespace autoref::tools
