// Compares the settings of two experiments of one kind. Declared in experiment_kinds.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "runner/batch/experiment_kinds.hpp"
#include "runner/experiments/situations_text.hpp"
#include "runner/experiments/tuning_settings.hpp"
#include "runner/experiments/with_kind.hpp"
#include "runner/io/words.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

using Values = std::map<std::string, std::string>;  // by path

// Leaves out aliases, which only set other settings.
Values values_of(const std::vector<Setting>& settings) {
  Values values;
  for (const Setting& setting : settings) {
    if (!is_alias(setting)) values[setting.path] = value_of(setting);
  }
  return values;
}

Values values_of(const Sweep& sweep) {
  GameSettings base = sweep.base;
  Values values = values_of(settings_of(base));
  values["seed"] = std::to_string(sweep.seed);
  return values;
}

Values values_of(const JudgeSchedule& schedule) {
  GameSettings base = schedule.base;
  Values values = values_of(settings_of(base));
  std::vector<std::string> matchups;
  for (const auto& matchup : schedule.matchups) matchups.push_back(name_of(matchup));
  values["matchups"] = listed(matchups);
  values["teams"] = listed(schedule.teams);
  for (const NamedSeed& seed : schedule.seeds) {
    values[seed.name.empty() ? "seed" : "seeds." + seed.name] = std::to_string(seed.value);
  }
  return values;
}

void add(const Teams& teams, std::string_view branch, const RobotTypes& types, Values& values) {
  for (auto [name, team] : teams) {
    values.merge(values_of(settings_of(team, types, fmt::format("{}.{}.", branch, name))));
  }
}

Values values_of(const NamedTeams& named) {
  GameSettings base = named.base;
  Values values = values_of(settings_of(base));
  std::erase_if(values, [](const auto& value) { return value.first.starts_with("teams."); });
  add(named.teams, "teams", named.base.types, values);
  values["seed"] = std::to_string(named.seed);
  return values;
}

Values values_of(const Gauntlet& gauntlet) {
  Values values = values_of(static_cast<const NamedTeams&>(gauntlet));
  add(gauntlet.challengers, "challengers", gauntlet.base.types, values);
  return values;
}

// The seeding decides which teams meet in which tie.
Values values_of(const Knockout& knockout) {
  Values values = values_of(static_cast<const NamedTeams&>(knockout));
  values["order"] = listed(knockout.order);
  return values;
}

Values values_of(const Situations& situations) {
  GameSettings base = situations.base;
  Values values = values_of(settings_of(base));
  std::erase_if(values, [](const auto& value) { return value.first.starts_with("teams."); });
  add(situations.attackers, "attackers", situations.base.types, values);
  add(situations.defenders, "defenders", situations.base.types, values);
  values.merge(situation_values(situations));
  values["seed"] = std::to_string(situations.seed);
  return values;
}

Values values_of(const Tuning& tuning) {
  Tuning copy = tuning;
  Values values = values_of(settings_of(copy.base));
  std::erase_if(values, [](const auto& value) { return value.first.starts_with("teams."); });
  values.merge(values_of(settings_of(copy.team, copy.base.types, "team.")));
  for (TunedParameter& parameter : copy.parameters) values.merge(values_of(settings_of(parameter)));
  values.merge(values_of(settings_of(copy)));
  values.merge(values_of(weight_settings_of(copy)));
  add(tuning.opponents, "opponents", tuning.base.types, values);
  values["seed"] = std::to_string(tuning.seed);
  return values;
}

// Ignores teams that occur in only one of the experiments: they do not affect the other teams'
// games.
void keep_teams_of_both(Teams& one, Teams& other) {
  std::erase_if(one, [&other](const auto& team) { return !other.contains(team.first); });
  std::erase_if(other, [&one](const auto& team) { return !one.contains(team.first); });
}

// Ignores seeds that occur in only one of the experiments: each has games of its own.
void keep_seeds_of_both(JudgeSchedule& one, const JudgeSchedule& other) {
  std::erase_if(one.seeds, [&other](const NamedSeed& seed) {
    return std::none_of(other.seeds.begin(), other.seeds.end(),
                        [&seed](const NamedSeed& its) { return its.name == seed.name; });
  });
}

void keep_what_is_in_both(Sweep& /*here*/, Sweep& /*there*/) {}
void keep_what_is_in_both(Tuning& /*here*/, Tuning& /*there*/) {}
void keep_what_is_in_both(JudgeSchedule& here, JudgeSchedule& there) {
  keep_seeds_of_both(here, there);
  keep_seeds_of_both(there, here);
}
void keep_what_is_in_both(NamedTeams& here, NamedTeams& there) {
  keep_teams_of_both(here.teams, there.teams);
}
void keep_what_is_in_both(Gauntlet& here, Gauntlet& there) {
  keep_teams_of_both(here.teams, there.teams);
  keep_teams_of_both(here.challengers, there.challengers);
}

// Likewise situations.
void keep_what_is_in_both(Situations& here, Situations& there) {
  keep_teams_of_both(here.attackers, there.attackers);
  keep_teams_of_both(here.defenders, there.defenders);
  std::erase_if(here.situations,
                [&there](const auto& one) { return !there.situations.contains(one.first); });
  std::erase_if(there.situations,
                [&here](const auto& one) { return !here.situations.contains(one.first); });
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

}  // namespace

std::string changes_between(const Scenario& here, const Scenario& there) {
  return with_kind(here, [&there](auto experiment) {
    const auto* other = std::get_if<decltype(experiment)>(&there.content);
    if (other == nullptr) return std::string();
    auto its = *other;
    keep_what_is_in_both(experiment, its);
    return changes_between(values_of(experiment), values_of(its));
  });
}

}  // namespace autoref::runner
