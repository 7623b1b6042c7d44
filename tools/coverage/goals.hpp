// Random games with known parameters.
#pragma once

#include <boost/random/poisson_distribution.hpp>
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

}  // namespace autoref::coverage
