// The parameters of a team, which a scenario sets in `params:`. A team's style lists its numbers in
// visit() (soccer/parameters.hpp).
#pragma once

#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "soccer/parameters.hpp"

namespace autoref::strategies {

// A parameter that users can set, and its default.
struct Tunable : Parameter {
  double standard = 0;   // the default
  bool is_flag = false;  // either 0 or 1
};

// The value in `params`, or the default.
inline double value_of(const Tunable& tunable, const std::map<std::string, double>& params) {
  const auto given = params.find(std::string(tunable.name));
  return given == params.end() ? tunable.standard : given->second;
}

// The numbers of `style`, with its values as defaults.
template <HasParameters Style>
std::vector<Tunable> tunables_of(const Style& style) {
  std::vector<Tunable> all;
  Style::visit(style, [&all](const auto& value, const Parameter& about) {
    const bool is_flag = std::is_same_v<decltype(value), const bool&>;
    all.push_back({about, static_cast<double>(value), is_flag});
  });
  return all;
}

// `style` with the numbers set by `params`; a flag is set by anything but 0.
template <HasParameters Style>
Style tuned(const Style& style, const std::map<std::string, double>& params) {
  Style result = style;
  Style::visit(result, [&params](auto& value, const Parameter& about) {
    const auto given = params.find(std::string(about.name));
    if (given == params.end()) return;
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, bool>) {
      value = given->second != 0;
    } else {
      value = given->second;
    }
  });
  return result;
}

}  // namespace autoref::strategies
