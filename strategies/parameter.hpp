// A number that a team can be tuned with, from a scenario's `params:`.
#pragma once

#include <map>
#include <string>
#include <string_view>

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

}  // namespace autoref::strategies
