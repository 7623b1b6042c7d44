// Distributions to draw numbers from, and their form in scenario files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "game/settings/fields.hpp"
#include "game/settings/yaml.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {

struct Distribution {
  enum class Kind : std::uint8_t { kFixed, kUniform, kNormal };

  // Implicit, so that a number is a distribution with a fixed value.
  constexpr Distribution(double value = 0) : first(value) {}
  static Distribution uniform(double low, double high) { return {Kind::kUniform, low, high}; }
  static Distribution normal(double mean, double sd) { return {Kind::kNormal, mean, sd}; }
  bool operator==(const Distribution&) const = default;

  Kind kind = Kind::kFixed;
  double first = 0;   // the fixed value, the lower end, or the mean
  double second = 0;  // the upper end, or the standard deviation

 private:
  constexpr Distribution(Kind of, double one, double other) : kind(of), first(one), second(other) {}
};

// The distribution as written in scenario files: "1.5", "[1.0, 2.0]" or "{ mean: 1.5, sd: 0.2 }".
std::string text_of(const Distribution& distribution);

// Draws a number. A normal distribution is truncated three standard deviations from its mean and at
// the ends of `range`, which must contain the mean.
double drawn(const Distribution& distribution, const Range& range, RandomStream& random);

// Reads a number, [low, high] or { mean, sd }. Throws InputError if the distribution extends beyond
// `range`, except for the tails of a normal distribution.
Distribution read_distribution(const game::YamlFile& file, const game::YamlEntry& entry,
                               const std::string& path, const Range& range, std::string_view unit);

}  // namespace autoref::experiments
