#include "strategies/parameter.hpp"

namespace autoref::strategies {

double value_of(const Parameter& parameter, const std::map<std::string, double>& params) {
  const auto given = params.find(std::string(parameter.name));
  return given == params.end() ? parameter.standard : given->second;
}

}  // namespace autoref::strategies
