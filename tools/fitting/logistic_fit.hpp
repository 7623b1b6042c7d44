// Logistic regression.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "game/play_counts/chance.hpp"
#include "tools/fitting/scores.hpp"

namespace autoref::tools {

template <std::size_t kCount>
struct LogisticSample {
  std::array<double, kCount> features{};
  bool has_happened = false;
};

// The most probable coefficients, by Newton's method. The prior of every coefficient is normal,
// with mean 0 and variance 1.
template <std::size_t kCount>
std::array<double, kCount> fit_logistic(const std::vector<LogisticSample<kCount>>& samples) {
  constexpr int kRounds = 40;
  using Vector = Eigen::Matrix<double, static_cast<int>(kCount), 1>;
  using Matrix = Eigen::Matrix<double, static_cast<int>(kCount), static_cast<int>(kCount)>;
  Vector coefficients = Vector::Zero();
  for (int round = 0; round < kRounds; ++round) {
    Vector gradient = -coefficients;
    Matrix curvature = Matrix::Identity();
    for (const LogisticSample<kCount>& sample : samples) {
      const Vector x(sample.features.data());
      const double p = 1 / (1 + std::exp(-coefficients.dot(x)));
      gradient += ((sample.has_happened ? 1.0 : 0.0) - p) * x;
      curvature += p * (1 - p) * x * x.transpose();
    }
    const Vector step = curvature.ldlt().solve(gradient);
    coefficients += step;
    if (step.norm() < 1e-9) break;
  }
  std::array<double, kCount> result{};
  std::copy(coefficients.begin(), coefficients.end(), result.begin());
  return result;
}

template <std::size_t kCount>
Predictions predictions_of(const std::array<double, kCount>& coefficients,
                           const std::vector<LogisticSample<kCount>>& samples) {
  Predictions predictions;
  predictions.reserve(samples.size());
  for (const LogisticSample<kCount>& sample : samples) {
    predictions.push_back({game::probability(coefficients, sample.features), sample.has_happened});
  }
  return predictions;
}

}  // namespace autoref::tools
