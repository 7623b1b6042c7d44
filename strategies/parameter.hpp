// A tunable parameter of a team, set by a scenario's `params:`.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::strategies {

struct Parameter {
  std::string_view name;  // as in `params:`
  std::string_view unit;  // such as "m" or "m/s"; "1" for fractions and counts
  double standard = 0;    // the default
  double least = 0;
  double most = 0;
  std::string_view about;  // one sentence
};

// The parameter's value in `params`, or its default.
double value_of(const Parameter& parameter, const std::map<std::string, double>& params);

// One number of a team's style, and its parameter. The parameter takes its default from the style.
template <typename Style>
struct TunableOf {
  double Style::*number;
  Parameter about;
};

template <typename Style>
using TunablesOf = std::span<const TunableOf<Style>>;

// The numbers of `style` as parameters, with the style's values as defaults.
template <typename Style>
std::vector<Parameter> parameters_of(TunablesOf<Style> tunables, const Style& style) {
  std::vector<Parameter> all;
  for (const TunableOf<Style>& tunable : tunables) {
    all.push_back(tunable.about);
    all.back().standard = style.*tunable.number;
  }
  return all;
}

// `style` with the numbers set by `params`.
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
