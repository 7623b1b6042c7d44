#include "runner/experiment_kinds.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "runner/errors.hpp"
#include "runner/fields.hpp"
#include "runner/roundrobin_plan.hpp"
#include "runner/standings_report.hpp"
#include "runner/summary.hpp"

namespace autoref::runner {
namespace {

using Values = std::map<std::string, std::string>;  // by path

// Calls the overload of `work` for the scenario's kind of experiment.
template <typename Work>
auto with_kind(const Scenario& scenario, const Work& work) {
  if (const auto* sweep = std::get_if<Sweep>(&scenario.content)) return work(*sweep);
  if (const auto* robin = std::get_if<RoundRobin>(&scenario.content)) return work(*robin);
  throw std::logic_error(fmt::format("a {} is no experiment", kind_of(scenario)));
}

// Without those that only set others.
Values values_of(const std::vector<Setting>& settings) {
  Values values;
  for (const Setting& setting : settings) {
    if (!is_alias(setting)) values[setting.path] = value_of(setting);
  }
  return values;
}

Values told_by(const Sweep& sweep) {
  GameConfiguration base = sweep.base;
  Values values = values_of(settings_of(base));
  values["seed"] = std::to_string(sweep.seed);
  return values;
}

Values told_by(const RoundRobin& robin) {
  GameConfiguration base = robin.base;
  Values values = values_of(settings_of(base));
  std::erase_if(values, [](const auto& value) { return value.first.starts_with("teams."); });
  for (auto [name, team] : robin.teams) {
    values.merge(values_of(settings_of(team, base.types, fmt::format("teams.{}.", name))));
  }
  values["seed"] = std::to_string(robin.seed);
  return values;
}

// What both have: a team that only one has changes no game of the others.
void keep_teams_of_both(const RoundRobin& one, RoundRobin& other) {
  std::erase_if(other.teams, [&one](const auto& team) { return !one.teams.contains(team.first); });
}

void keep_what_is_in_both(Sweep& /*here*/, Sweep& /*there*/) {}
void keep_what_is_in_both(RoundRobin& here, RoundRobin& there) {
  keep_teams_of_both(here, there);
  keep_teams_of_both(there, here);
}

std::string changes_between(const Values& here, const Values& there) {
  std::string changes;
  const auto note = [&changes](const std::string& path, const std::string& x,
                               const std::string& y) {
    if (x == y) return;
    changes += fmt::format("{}{} is {} here and {} there", changes.empty() ? "" : "; ", path, x, y);
  };
  const std::string missing = "not given";
  for (const auto& [path, value] : here) {
    note(path, value, there.contains(path) ? there.at(path) : missing);
  }
  for (const auto& [path, value] : there) {
    if (!here.contains(path)) note(path, missing, value);
  }
  return changes;
}

std::vector<std::string> value_columns(const Sweep& sweep) {
  std::vector<std::string> paths;
  paths.reserve(sweep.factors.size());
  for (const Factor& factor : sweep.factors) paths.push_back(factor.path);
  return paths;
}

std::vector<std::string> value_columns(const RoundRobin& /*robin*/) { return {}; }

ExperimentResults results_of(const Sweep& sweep, const RowFormat& format,
                             const std::vector<Cells>& rows) {
  ExperimentResults results;
  results.groups = grouped(sweep, format, rows);
  results.files = {{"summary.csv", "a row per value", summary_csv(sweep, results.groups)}};
  results.table = summary_table(sweep, results.groups);
  return results;
}

ExperimentResults results_of(const RoundRobin& robin, const RowFormat& format,
                             const std::vector<Cells>& rows) {
  ExperimentResults results;
  results.groups = grouped(robin, format, rows);
  results.standings = standings_of(results.groups);
  results.files = {{"summary.csv", "a row per matchup", matchups_csv(results.groups)},
                   {"standings.csv", "a row per team", standings_csv(results.standings)}};
  results.table = matchups_table(results.groups) + "\n" + standings_table(results.standings);
  return results;
}

}  // namespace

bool is_experiment(const Scenario& scenario) {
  return std::holds_alternative<Sweep>(scenario.content) ||
         std::holds_alternative<RoundRobin>(scenario.content);
}

std::vector<PlannedGame> plan(const Scenario& scenario) {
  return with_kind(scenario, [](const auto& experiment) { return plan(experiment); });
}

std::vector<PlannedGame> plan_of(const Scenario& scenario, const std::filesystem::path& file) {
  try {
    return plan(scenario);
  } catch (const std::invalid_argument& error) {
    throw InputError({file.string()}, "", error.what());
  }
}

std::vector<std::string> value_columns(const Scenario& scenario) {
  return with_kind(scenario, [](const auto& experiment) { return value_columns(experiment); });
}

std::string changes_between(const Scenario& here, const Scenario& there) {
  return with_kind(here, [&there](auto experiment) {
    const auto* other = std::get_if<decltype(experiment)>(&there.content);
    if (other == nullptr) return std::string();
    auto its = *other;
    keep_what_is_in_both(experiment, its);
    return changes_between(told_by(experiment), told_by(its));
  });
}

ExperimentResults results_of(const Scenario& scenario, const RowFormat& format,
                             const std::vector<Cells>& rows) {
  return with_kind(scenario,
                   [&](const auto& experiment) { return results_of(experiment, format, rows); });
}

}  // namespace autoref::runner
