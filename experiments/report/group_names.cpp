#include "experiments/report/group_names.hpp"

#include <fmt/format.h>

#include "io/words.hpp"

namespace autoref::experiments {
std::vector<std::string> value_heads(const Scenario& scenario, const std::vector<Group>& groups) {
  std::vector<std::string> heads = scenario.experiment().value_columns();
  if (groups.empty() || heads.size() == groups.front().values.size()) return heads;
  heads = {"a", "b"};
  heads.resize(groups.front().values.size());
  return heads;
}

std::string axis_name(const Scenario& scenario) {
  const std::vector<std::string> paths = scenario.experiment().value_columns();
  return paths.empty() ? "matchup" : io::listed(paths);
}

std::vector<std::string> names_of(const Scenario& scenario, const std::vector<Group>& groups) {
  const char* between = scenario.experiment().value_columns().empty() ? " : " : ", ";
  std::vector<std::string> names;
  names.reserve(groups.size());
  for (const Group& group : groups) {
    names.push_back(fmt::format("{}", fmt::join(group.values, between)));
  }
  return names;
}

std::optional<NumericFactor> numeric_factor(const Scenario& scenario,
                                            const std::vector<Group>& groups) {
  const std::vector<Factor> factors = scenario.experiment().varied_settings();
  if (factors.size() != 1 || groups.size() < 2) return std::nullopt;
  const Factor& factor = factors.front();
  const std::optional<std::vector<double>> values = numbers_of(factor);
  if (!values) return std::nullopt;
  return NumericFactor{factor.path, *values};
}

}  // namespace autoref::experiments
