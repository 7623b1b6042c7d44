// A number that a team can be tuned with, from a scenario's `params:`.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::strategies {

struct Parameter {
  std::string_view name;  // as in `params:`
  std::string_view unit;  // such as "m" or "m/s"; "1" for shares and counts
  double standard = 0;    // the value without `params:`
  double least = 0;
  double most = 0;
  std::string_view about;  // one sentence
};

// What `params` gives the parameter, or its standard.
double value_of(const Parameter& parameter, const std::map<std::string, double>& params);

// One number of a team's style, and what is said of it; the standard is the style's own.
template <typename Style>
struct TunableOf {
  double Style::*number;
  Parameter about;
};

template <typename Style>
using TunablesOf = std::span<const TunableOf<Style>>;

// The numbers of `style` as a team's parameters, its own values being their standards.
template <typename Style>
std::vector<Parameter> parameters_of(TunablesOf<Style> tunables, const Style& style) {
  std::vector<Parameter> all;
  for (const TunableOf<Style>& tunable : tunables) {
    all.push_back(tunable.about);
    all.back().standard = style.*tunable.number;
  }
  return all;
}

// `style` with the numbers that `params` gives.
template <typename Style>
Style tuned(TunablesOf<Style> tunables, const Style& style,
            const std::map<std::string, double>& params) {
  Style result = style;
  for (const TunableOf<Style>& tunable : tunables) {
    Parameter parameter = tunable.about;
    parameter.standard = style.*tunable.number;
    result.*tunable.number = value_of(parameter, params);
  }
  return result;
}

}  // namespace autoref::strategies
