// Test functions for optimisers, with a known optimum and noise like that of games.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "experiments/tune/optimiser.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {

// Goals per game lost at a point of the unit box; 0 at the optimum, which is at 0.65 in every
// coordinate. The start, 0.35 everywhere, loses 1.5 goals for any number of dimensions.
using Loss = std::function<double(const Point& unit)>;

inline constexpr double kOptimum = 0.65;
inline constexpr double kStart = 0.35;
inline constexpr double kStartLoss = 1.5;
inline constexpr double kPairNoise = 2.3;  // standard deviation of a pair of legs, in goals

// A bowl: all parameters matter equally and independently of each other.
inline double bowl(const Point& unit) {
  const Point off = (unit.array() - kOptimum) / (kOptimum - kStart);
  return kStartLoss * off.squaredNorm() / static_cast<double>(unit.size());
}

// Curved valleys like Rosenbrock's, one for each pair of parameters: leaving the valley's floor
// costs four times as much as moving along it. The size must be even.
inline double valley(const Point& unit) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < unit.size(); i += 2) {
    const double along = (unit[i] - kOptimum) / (kOptimum - kStart);
    const double across = (unit[i + 1] - kOptimum) / (kOptimum - kStart);
    const double off = across - along - along * along / 2;
    sum += along * along + 4 * off * off;
  }
  return kStartLoss * sum / static_cast<double>(unit.size());
}

struct NoisySearch {
  Search search;
  int dimensions = 2;
  int pairs = 4;                // pairs of legs per score
  double step = 0.2;            // fraction of the range
  bool against_itself = false;  // SPSA: one noisy difference instead of two noisy scores
  double noise = kPairNoise;

  std::vector<Axis> axes() const {
    return std::vector<Axis>(static_cast<std::size_t>(dimensions),
                             Axis{0, 1 / step, kStart / step, 0});
  }

  // The loss at the best point after all iterations.
  double final_loss(const Loss& loss) const {
    const auto optimiser = make_optimiser(search, axes());
    RandomStream random(mix_bits(search.seed) + 77);
    const double spread = noise / std::sqrt(pairs);
    for (int i = 0; i < search.iterations; ++i) {
      std::vector<Score> scores;
      for (const Candidate& candidate : optimiser->ask()) {
        const double shared = against_itself && !scores.empty() ? 0 : spread * random.normal();
        scores.push_back(shared - loss(step * candidate.point));
      }
      optimiser->tell(scores);
    }
    return loss(step * optimiser->best());
  }

  // The loss averaged over this many seeds.
  double mean_loss(const Loss& loss, int seeds) const {
    double sum = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      NoisySearch with_seed = *this;
      with_seed.search.seed = static_cast<std::uint64_t>(seed);
      sum += with_seed.final_loss(loss);
    }
    return sum / seeds;
  }

  // Games per iteration.
  int games() const {
    if (against_itself) return 2 * pairs;
    return 2 * pairs * static_cast<int>(make_optimiser(search, axes())->ask().size());
  }
};

}  // namespace autoref::experiments
