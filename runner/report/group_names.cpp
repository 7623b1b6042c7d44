#include "runner/report/group_names.hpp"

#include <fmt/format.h>

#include "runner/words.hpp"

namespace autoref::runner {
namespace {

std::string settings_text(const Cells& paths, const Cells& values) {
  std::vector<std::string> settings;
  for (std::size_t i = 0; i < values.size(); ++i) settings.push_back(paths[i] + "=" + values[i]);
  return fmt::format("{}", fmt::join(settings, ", "));
}

}  // namespace

std::vector<std::string> value_heads(const Scenario& scenario, const std::vector<Group>& groups) {
  std::vector<std::string> heads = value_columns(scenario);
  if (groups.empty() || heads.size() == groups.front().values.size()) return heads;
  heads = {"a", "b"};
  heads.resize(groups.front().values.size());
  return heads;
}

std::string axis_name(const Scenario& scenario) {
  const std::vector<std::string> paths = value_columns(scenario);
  return paths.size() == 1 ? paths.front() : paths.empty() ? "matchup" : "settings";
}

std::vector<std::string> names_of(const Scenario& scenario, const std::vector<Group>& groups) {
  const std::vector<std::string> paths = value_columns(scenario);
  std::vector<std::string> names;
  for (const Group& group : groups) {
    const bool has_settings = paths.size() == group.values.size() && paths.size() > 1;
    names.push_back(has_settings ? settings_text(paths, group.values)
                                 : fmt::format("{}", fmt::join(group.values, " : ")));
  }
  return names;
}

std::optional<NumericFactor> numeric_factor(const Scenario& scenario,
                                            const std::vector<Group>& groups) {
  const std::vector<std::string> paths = value_columns(scenario);
  if (paths.size() != 1 || groups.size() < 2) return std::nullopt;
  NumericFactor factor{paths.front(), {}};
  for (const Group& group : groups) {
    const std::optional<double> value = number_in(group.values.front());
    if (!value) return std::nullopt;
    factor.values.push_back(*value);
  }
  return factor;
}

}  // namespace autoref::runner
