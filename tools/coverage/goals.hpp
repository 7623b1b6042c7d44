// Random games with known parameters.
#pragma once

#include <algorithm>
#include <boost/random/gamma_distribution.hpp>
#include <boost/random/poisson_distribution.hpp>
#include <functional>
#include <numbers>
#include <vector>

#include "soccer/random.hpp"

namespace autoref::coverage {

// Expected goals per game of both teams; both must be above 0.
struct Means {
  double a = 0;
  double b = 0;
};

struct Score {
  int a = 0;
  int b = 0;

  int difference() const { return a - b; }
};

inline Score play(const Means& means, RandomStream& random) {
  const int a = boost::random::poisson_distribution<int>(means.a)(random);
  const int b = boost::random::poisson_distribution<int>(means.b)(random);
  return {a, b};
}

inline std::vector<Score> play(const Means& means, int games, RandomStream& random) {
  std::vector<Score> scores;
  for (int i = 0; i < games; ++i) scores.push_back(play(means, random));
  return scores;
}

// The mean difference of each pair of legs: games 0 and 1, games 2 and 3, ...
inline std::vector<double> pair_differences(const std::vector<Score>& scores) {
  std::vector<double> differences;
  for (std::size_t i = 0; i + 1 < scores.size(); i += 2) {
    differences.push_back((scores[i].difference() + scores[i + 1].difference()) / 2.0);
  }
  return differences;
}

inline constexpr double kLeastMean = 1e-9;

// Draws the mean goal difference of the next pair of legs.
using Pairs = std::function<double(RandomStream&)>;

struct Goals {
  const char* name;
  Pairs (*pairs)(double mean, double sd);
};

// Pairs whose legs are independent and each have the standard deviation `sd`.
inline Pairs normal_pairs(double mean, double sd) {
  return [=](RandomStream& random) { return mean + sd / std::numbers::sqrt2 * random.normal(); };
}

inline double pair_of(const Means& means, RandomStream& random) {
  return pair_differences(play(means, 2, random)).front();
}

// The variance of a game's difference is the sum of both teams' expected goals.
inline Means means_with(double mean, double variance) {
  return {std::max((variance + mean) / 2, kLeastMean), std::max((variance - mean) / 2, kLeastMean)};
}

inline Pairs poisson_pairs(double mean, double sd) {
  return
      [means = means_with(mean, sd * sd)](RandomStream& random) { return pair_of(means, random); };
}

// Pairs that differ in the number of goals: both teams' expected goals have a common factor with
// mean 1 and variance `uneven`, which adds the fraction `uneven` of the squared lead to a game's
// variance.
inline Pairs uneven_pairs(double mean, double sd, double uneven) {
  const Means means = means_with(mean, sd * sd - uneven * mean * mean);
  return [=](RandomStream& random) {
    const double factor = boost::random::gamma_distribution<double>(1 / uneven, uneven)(random);
    return pair_of({std::max(means.a * factor, kLeastMean), std::max(means.b * factor, kLeastMean)},
                   random);
  };
}

inline constexpr Goals kNormal = {"normal", normal_pairs};
inline constexpr Goals kPoisson = {"Poisson", poisson_pairs};
inline constexpr Goals kUneven = {
    "uneven", [](double mean, double sd) { return uneven_pairs(mean, sd, 0.25); }};
inline constexpr Goals kVeryUneven = {
    "very uneven", [](double mean, double sd) { return uneven_pairs(mean, sd, 1); }};

}  // namespace autoref::coverage
