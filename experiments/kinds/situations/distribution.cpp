#include "experiments/kinds/situations/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr double kCutOff = 3;  // standard deviations

// With its mean on an end of the range, half of the draws are inside.
constexpr int kMostDraws = 64;

double drawn_normal(double mean, double sd, const Range& range, RandomStream& random) {
  const double low = std::max(range.low, mean - kCutOff * sd);
  const double high = std::min(range.high, mean + kCutOff * sd);
  for (int i = 0; i < kMostDraws; ++i) {
    const double value = mean + sd * random.normal();
    if (value >= low && value <= high) return value;
  }
  return mean;
}

}  // namespace

std::string text_of(const Distribution& distribution) {
  std::string first = io::text_of(distribution.first);
  switch (distribution.kind) {
    case Distribution::Kind::kUniform:
      return fmt::format("[{}, {}]", first, io::text_of(distribution.second));
    case Distribution::Kind::kNormal:
      return fmt::format("{{ mean: {}, sd: {} }}", first, io::text_of(distribution.second));
    case Distribution::Kind::kFixed:
      break;
  }
  return first;
}

double drawn(const Distribution& distribution, const Range& range, RandomStream& random) {
  switch (distribution.kind) {
    case Distribution::Kind::kUniform:
      return distribution.first + (distribution.second - distribution.first) * random.uniform();
    case Distribution::Kind::kNormal:
      return drawn_normal(distribution.first, distribution.second, range, random);
    case Distribution::Kind::kFixed:
      break;
  }
  return distribution.first;
}

}  // namespace autoref::experiments
