// The keys of scenario files, as listed by the kinds of experiments.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/schedule/factor.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {

class TopReader;

using TextByPath = std::map<std::string, std::string>;

// A team given in a key.
struct TeamAt {
  std::string path;  // "teams.bold"
  game::TeamSettings* team = nullptr;
};

// A row of the reference page: one or several keys, their possible values and their meaning. Names
// of keys and values are between backticks.
struct KeyRow {
  std::string names;
  std::string value;
  std::string about;
};

// The keys nested inside another key, as a section of the reference page.
struct KeysBelow {
  std::string title;  // such as "the test"; follows the kind's name
  std::string about;  // a sentence before the table; may be empty
  std::vector<KeyRow> rows;
};

// A row for each setting, under the last part of its path, with its possible values and its current
// value. In a new experiment, the current value is the default. Settings in `required` have no
// default.
std::vector<KeyRow> rows_of(const std::vector<game::Setting>& settings,
                            const std::vector<std::string>& required = {});

// A key of a kind's scenario file, and everything that depends on it. A function is left empty if
// it does not apply to the key.
struct Key {
  std::string name;   // the key's name in the file
  std::string value;  // possible values for the reference page: "whole number"; empty with `below`
  std::string about;  // the key's meaning, as a phrase

  // Reads the key or, if it is absent, sets the default. Called in the keys' order. Throws
  // InputError.
  std::function<void(TopReader&)> read = {};
  // Checks the key once all keys have been read and fit together. Throws InputError.
  std::function<void(TopReader&)> verify = {};
  // The key's lines in effective.yaml; reading them back gives the same experiment.
  std::function<std::string()> text = {};
  // Settings to name in a message if a results folder has rows of games with other settings.
  std::function<TextByPath()> values = {};
  // Names of those entries of the key whose games depend on no other entry. You may add or remove
  // such entries even if the results folder already has rows.
  std::function<std::vector<std::string>()> entries = {};
  // The teams that the key defines, with their paths.
  std::function<std::vector<TeamAt>()> teams = {};
  // The values that --pairs and --seed set.
  int* pairs = nullptr;
  std::function<std::optional<std::uint64_t>()> seed = {};
  std::function<void(std::uint64_t)> set_seed = {};
  std::function<std::string()> seed_text = {};
  std::function<KeysBelow()> below = {};
  // Settings shared by all games.
  game::GameSettings* base = nullptr;
};

inline std::vector<Factor> no_factors() { return {}; }

// The key `base` with the teams that play all games, but without the settings of the experiment's
// factors.
Key base_key(game::GameSettings& base, std::function<std::vector<Factor>()> factors);

// The key `base` without teams and without the settings of the experiment's factors; `remedy` says
// where the teams are listed.
Key base_without_teams_key(game::GameSettings& base, std::string remedy,
                           std::string about = "shared by every game",
                           std::function<std::vector<Factor>()> factors = no_factors);

// A key with teams by name. Settings of `base` are their defaults.
Key teams_key(const std::string& name, std::string about, Teams& teams, game::GameSettings& base,
              TeamCount count = {});

// The keys `base` and `teams` of an experiment between named teams.
Key base_key(NamedTeams& named, std::function<std::vector<Factor>()> factors = no_factors);
Key teams_key(NamedTeams& named, std::string about, TeamCount count = {});

Key pairs_key(int& pairs, std::string about);
Key seed_key(std::uint64_t& seed);

// The settings of an experiment that have keys of their own.
using ListSettings = std::function<std::vector<game::Setting>()>;

// The key of the setting `name`.
Key settings_key(const std::string& name, const ListSettings& settings);

// The key of all settings below `name`, such as "test.pairs". `title` is that of its section on the
// reference page.
Key settings_branch_key(const std::string& name, const std::string& title, std::string about,
                        const ListSettings& settings);

// The same key of one setting, which every scenario file must contain.
Key without_default(Key key);

// The key `set_by_values`, which AutoRef writes into effective.yaml. The key lists the settings
// that each value of the factors sets. A file in which this list has been changed is refused.
Key set_by_values_key(const game::GameSettings& base, std::function<std::vector<Factor>()> factors);

// The values of all settings except aliases.
TextByPath values_of(const std::vector<game::Setting>& settings);

}  // namespace autoref::experiments
