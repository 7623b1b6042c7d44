#include "experiments/kinds/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/reading/factor_reader.hpp"
#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "io/yaml_text.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kSetByValues = "set_by_values";
constexpr const char* kTeamsOfBase = "teams.";

std::string block_of(const SetByValues& set_by_values) {
  if (set_by_values.empty()) return "";
  std::string text =
      fmt::format("{}:  # settings implied by each value; written by AutoRef\n", kSetByValues);
  for (const auto& [name, values] : set_by_values) {
    text += fmt::format("  {}:\n", io::quoted_scalar(name));
    for (const auto& [path, value] : values) text += fmt::format("    {}: {}\n", path, value);
  }
  return text;
}

SetByValues read_set_by_values(const game::YamlFile& file, const game::YamlEntry& entry) {
  SetByValues found;
  for (const game::YamlEntry& value : file.entries(entry, kSetByValues, {})) {
    for (const game::YamlEntry& setting : file.entries(value, value.key, {}))
      found[value.key][setting.key] = file.scalar(setting, setting.key, "a plain value", false);
  }
  return found;
}

// The settings that the base does not have itself: those that the factors' values set, and the
// factors' own, unless the user gave them. The latter may differ between games that do not set
// them, if these have other rule books.
SetByValues not_of_base(const game::GameSettings& base, const std::vector<Factor>& factors) {
  SetByValues all = set_by_values(base, factors);
  for (const Factor& factor : factors) {
    const std::string path = game::full_path(factor.path);
    if (path != kRuleBookPath && !base.given.contains(path)) all[factor.path][path];
  }
  return all;
}

TextByPath values_of_base(const game::GameSettings& base) {
  game::GameSettings copy = base;
  TextByPath values = values_of(game::settings_of(copy));
  std::erase_if(values, [](const auto& value) { return is_decided_by_schedule(value.first); });
  return values;
}

std::vector<TeamAt> teams_at(const std::string& branch, Teams& teams) {
  std::vector<TeamAt> all;
  for (auto& [name, team] : teams) all.push_back({fmt::format("{}.{}", branch, name), &team});
  return all;
}

// The setting `name`, or the settings below it.
std::vector<game::Setting> settings_at(const ListSettings& settings, const std::string& name) {
  std::vector<game::Setting> its = settings();
  std::erase_if(its, [&name](const game::Setting& setting) {
    return setting.path != name && !setting.path.starts_with(name + ".");
  });
  return its;
}

}  // namespace

std::vector<KeyRow> rows_of(const std::vector<game::Setting>& settings,
                            const std::vector<std::string>& required) {
  std::vector<KeyRow> rows;
  for (const game::Setting& setting : settings) {
    const std::string name = setting.path.substr(setting.path.rfind('.') + 1);
    const bool is_required = std::find(required.begin(), required.end(), name) != required.end();
    rows.push_back(
        {fmt::format("`{}`", name),
         game::expected_of(setting) + (is_required ? "" : "; " + game::value_of(setting)),
         std::string(setting.about)});
  }
  return rows;
}

TextByPath values_of(const std::vector<game::Setting>& settings) {
  TextByPath values;
  for (const game::Setting& setting : settings) {
    if (!game::is_alias(setting)) values[setting.path] = game::value_of(setting);
  }
  return values;
}

Key base_key(game::GameSettings& base, std::function<std::vector<Factor>()> factors) {
  Key key{"base", "settings",
          "shared by every game: `teams`, `match`, `field`, `sim`, `types`, `measured`"};
  key.read = [&base](TopReader& top) { top.read_base(base); };
  key.text = [&base, factors = std::move(factors)] {
    return base_text(base, "", set_by_values(base, factors()));
  };
  key.values = [&base] { return values_of_base(base); };
  key.teams = [&base]() -> std::vector<TeamAt> {
    return {{"teams.a", &base.a}, {"teams.b", &base.b}};
  };
  key.base = &base;
  return key;
}

Key base_without_teams_key(game::GameSettings& base, std::string remedy, std::string about,
                           std::function<std::vector<Factor>()> factors) {
  Key key{"base", "settings", std::move(about)};
  key.read = [&base, remedy = std::move(remedy)](TopReader& top) {
    top.read_base(base, {"teams", remedy});
  };
  key.text = [&base, factors = std::move(factors)] {
    return base_text(base, kTeamsOfBase, not_of_base(base, factors()));
  };
  key.values = [&base] {
    TextByPath values = values_of_base(base);
    std::erase_if(values, [](const auto& value) { return value.first.starts_with(kTeamsOfBase); });
    return values;
  };
  key.base = &base;
  return key;
}

Key teams_key(const std::string& name, std::string about, Teams& teams, game::GameSettings& base,
              TeamCount count) {
  Key key{name, "teams by name", std::move(about)};
  key.read = [name, &teams, &base, count](TopReader& top) {
    NamedTeamsReader(top.file(), top.locations(), top.assignments())
        .read(top.required(name), teams, base, count);
  };
  key.text = [name, &teams, &base] { return teams_text(teams, name, base.types); };
  key.values = [name, &teams, &base] {
    TextByPath values;
    for (auto [its_name, team] : teams)
      values.merge(
          values_of(game::settings_of(team, base.types, fmt::format("{}.{}.", name, its_name))));
    return values;
  };
  key.entries = [&teams] {
    std::vector<std::string> names;
    for (const auto& [its_name, team] : teams) names.push_back(its_name);
    return names;
  };
  key.teams = [name, &teams] { return teams_at(name, teams); };
  return key;
}

Key base_key(NamedTeams& named, std::function<std::vector<Factor>()> factors) {
  return base_without_teams_key(named.base, "list teams by name under `teams`, outside the base",
                                "shared by every game", std::move(factors));
}

Key teams_key(NamedTeams& named, std::string about, TeamCount count) {
  return teams_key("teams", std::move(about), named.teams, named.base, count);
}

Key pairs_key(int& pairs, std::string about) {
  Key key{"pairs", "whole number", std::move(about)};
  key.read = [&pairs](TopReader& top) { pairs = top.pairs(); };
  key.text = [&pairs] { return fmt::format("pairs: {}\n", pairs); };
  key.pairs = &pairs;
  return key;
}

Key seed_key(std::uint64_t& seed) {
  Key key{"seed", "whole number", "the experiment's random seed"};
  key.read = [&seed](TopReader& top) { seed = top.seed(); };
  key.text = [&seed] { return fmt::format("seed: {}\n", seed); };
  key.values = [&seed] { return TextByPath{{"seed", std::to_string(seed)}}; };
  key.seed = [&seed] { return std::optional(seed); };
  key.set_seed = [&seed](std::uint64_t value) { seed = value; };
  key.seed_text = [&seed] { return std::to_string(seed); };
  return key;
}

Key settings_key(const std::string& name, const ListSettings& settings) {
  const KeyRow row = rows_of(settings_at(settings, name)).front();
  Key key{name, row.value, row.about};
  key.read = [settings, name](TopReader& top) {
    const game::YamlEntry* entry = top.find(name);
    if (entry == nullptr) return;
    top.locations()[name] = entry->location;
    game::SettingsReader(top.file(), settings(), top.locations()).read(*entry, name);
  };
  key.text = [settings, name] { return text_of(settings_at(settings, name)); };
  key.values = [settings, name] { return values_of(settings_at(settings, name)); };
  return key;
}

Key settings_branch_key(const std::string& name, const std::string& title, std::string about,
                        const ListSettings& settings) {
  Key key = settings_key(name, settings);
  key.value.clear();
  key.about = std::move(about);
  key.below = [settings, name, title]() -> KeysBelow {
    return {title, "", rows_of(settings_at(settings, name))};
  };
  return key;
}

Key without_default(Key key) {
  key.value = key.value.substr(0, key.value.rfind(';'));
  key.read = [name = key.name, read_setting = key.read](TopReader& top) {
    top.required(name);
    read_setting(top);
  };
  return key;
}

Key set_by_values_key(const game::GameSettings& base,
                      std::function<std::vector<Factor>()> factors) {
  Key key{kSetByValues, "",
          "written to `effective.yaml`: what each value sets; do not write it yourself"};
  const auto expected = [&base, factors = std::move(factors)] {
    return set_by_values(base, factors());
  };
  key.verify = [expected](TopReader& top) {
    const game::YamlEntry* entry = top.find(kSetByValues);
    if (entry == nullptr || read_set_by_values(top.file(), *entry) == expected()) return;
    top.file().refuse(entry->location, kSetByValues,
                      "does not match what base and the varied values set; leave it out");
  };
  key.text = [expected] { return block_of(expected()); };
  return key;
}

}  // namespace autoref::experiments
