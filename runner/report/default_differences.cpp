#include "runner/report/default_differences.hpp"

#include <fmt/format.h>

#include <map>
#include <type_traits>

#include "runner/batch/experiment_kinds.hpp"
#include "runner/experiments/cells.hpp"
#include "runner/experiments/reading/factor_reader.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

using Values = std::map<std::string, std::string>;  // by path
using Teams = std::map<std::string, TeamSettings>;

constexpr const char* kNothing = "{}";  // the value of a branch without changes

Values comparable_values(const std::vector<Setting>& settings) {
  Values values;
  for (const Setting& setting : settings) {
    if (!is_alias(setting) && !is_decided_by_schedule(setting.path)) {
      values[setting.path] = value_of(setting);
    }
  }
  return values;
}

void compare(const Values& here, const Values& defaults, std::vector<DefaultDifference>& found) {
  for (const auto& [path, value] : here) {
    const auto usual = defaults.find(path);
    const std::string by_default = usual == defaults.end() ? kNothing : usual->second;
    if (value != by_default) found.push_back({short_path(path), value, by_default});
  }
}

Values defaults_for(const GameSettings& game) {
  GameSettings usual;
  // The rule book sets other values too; only deviations from these are of interest.
  set_by_path(usual, "match.rules", game.match.rules.name);
  Values values = comparable_values(settings_of(usual));
  values["match.rules"] = referee::Match{}.rules.name;
  return values;
}

void compare_games(GameSettings game, bool has_named_teams, std::vector<DefaultDifference>& found) {
  Values here = comparable_values(settings_of(game));
  if (has_named_teams) {
    std::erase_if(here, [](const auto& value) { return value.first.starts_with("teams."); });
  }
  compare(here, defaults_for(game), found);
}

void compare_teams(const GameSettings& base, const Teams& teams,
                   std::vector<DefaultDifference>& found) {
  GameSettings usual;
  set_by_path(usual, "match.rules", base.match.rules.name);
  for (auto [name, team] : teams) {
    const std::string prefix = fmt::format("teams.{}.", name);
    compare(comparable_values(settings_of(team, base.types, prefix)),
            comparable_values(settings_of(usual.a, usual.types, prefix)), found);
  }
}

// A setting that a factor varies, or that a varied preset sets, has no single value.
void leave_out_factors(const Scenario& scenario, std::vector<DefaultDifference>& found) {
  if (const auto* sweep = std::get_if<Sweep>(&scenario.content)) {
    for (const auto& [value, settings] : set_by_values(*sweep)) {
      std::erase_if(found, [&settings = settings](const auto& difference) {
        return settings.contains(full_path(difference.path));
      });
    }
  }
  for (const std::string& factor : value_columns(scenario)) {
    std::erase_if(found, [&](const auto& difference) { return difference.path == factor; });
  }
}

}  // namespace

std::vector<DefaultDifference> differences_from_defaults(const Scenario& scenario) {
  std::vector<DefaultDifference> found;
  std::visit(
      [&found](const auto& content) {
        if constexpr (requires { content.base; }) {
          constexpr bool kHasTeams = requires { Teams(content.teams); };
          compare_games(content.base, kHasTeams, found);
          if constexpr (kHasTeams) compare_teams(content.base, content.teams, found);
          if constexpr (requires { content.challengers; })
            compare_teams(content.base, content.challengers, found);
        }
      },
      scenario.content);
  leave_out_factors(scenario, found);
  return found;
}

}  // namespace autoref::runner
