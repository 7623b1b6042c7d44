#include "experiments/report/default_differences.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <stdexcept>

#include "experiments/kinds/scenario.hpp"
#include "experiments/reading/factor_reader.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kNothing = "{}";  // the value of a branch without changes

TextByPath comparable_values(const std::vector<game::Setting>& settings) {
  TextByPath values;
  for (const game::Setting& setting : settings) {
    if (!game::is_alias(setting) && !is_decided_by_schedule(setting.path)) {
      values[setting.path] = game::value_of(setting);
    }
  }
  return values;
}

void compare(const TextByPath& here, const TextByPath& defaults,
             std::vector<DefaultDifference>& found) {
  for (const auto& [path, value] : here) {
    const auto usual = defaults.find(path);
    const std::string by_default = usual == defaults.end() ? kNothing : usual->second;
    if (value != by_default) found.push_back({game::short_path(path), value, by_default});
  }
}

TextByPath defaults_for(const game::GameSettings& game) {
  game::GameSettings usual;
  // The rule book sets other values too; only deviations from these are of interest.
  game::set_by_path(usual, "match.rules", game.match.rules.name);
  TextByPath values = comparable_values(game::settings_of(usual));
  values["match.rules"] = referee::Match{}.rules.name;
  return values;
}

void compare_games(game::GameSettings game, bool has_named_teams,
                   std::vector<DefaultDifference>& found) {
  TextByPath here = comparable_values(game::settings_of(game));
  if (has_named_teams) {
    std::erase_if(here, [](const auto& value) { return value.first.starts_with("teams."); });
  }
  compare(here, defaults_for(game), found);
}

void compare_team(const game::GameSettings& base, const TeamAt& at,
                  std::vector<DefaultDifference>& found) {
  game::GameSettings usual;
  game::set_by_path(usual, "match.rules", base.match.rules.name);
  const std::string prefix = at.path + ".";
  compare(comparable_values(game::settings_of(*at.team, base.types, prefix)),
          comparable_values(game::settings_of(usual.a, usual.types, prefix)), found);
}

void compare_key(const Key& key, const game::GameSettings& base,
                 std::vector<DefaultDifference>& found) {
  if (key.base != nullptr) return compare_games(base, !key.teams, found);
  if (!key.teams) return;
  for (const TeamAt& at : key.teams()) compare_team(base, at, found);
}

// A setting that a factor varies, or that a varied preset sets, has no single value.
void leave_out_factors(const game::GameSettings& base, const std::vector<Factor>& factors,
                       std::vector<DefaultDifference>& found) {
  for (const auto& [value, settings] : set_by_values(base, factors)) {
    std::erase_if(found, [&settings = settings](const auto& difference) {
      return settings.contains(game::full_path(difference.path));
    });
  }
  for (const Factor& factor : factors) {
    std::erase_if(found, [&](const auto& difference) { return difference.path == factor.path; });
  }
}

const game::GameSettings& base_of(const std::vector<Key>& keys) {
  for (const Key& key : keys) {
    if (key.base != nullptr) return *key.base;
  }
  throw std::logic_error("an experiment without a key for its base");
}

}  // namespace

std::vector<DefaultDifference> differences_from_defaults(const Experiment& experiment) {
  const std::unique_ptr<Experiment> copy = experiment.copy();
  const std::vector<Key> keys = copy->keys();
  const game::GameSettings& base = base_of(keys);
  std::vector<DefaultDifference> found;
  for (const Key& key : keys) compare_key(key, base, found);
  leave_out_factors(base, copy->varied_settings(), found);
  return found;
}

}  // namespace autoref::experiments
