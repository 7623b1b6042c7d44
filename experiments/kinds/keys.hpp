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

// The keys inside a key, as a section of the reference page.
struct KeysBelow {
  std::string title;  // "the test", after the kind's name
  std::string about;  // a sentence before the table; may be empty
  std::vector<KeyRow> rows;
};

// A row for each setting, under the last part of its name, with its possible values and its present
// value, which is the default in a new experiment. Settings in `required` have no default.
std::vector<KeyRow> rows_of(const std::vector<game::Setting>& settings,
                            const std::vector<std::string>& required = {});

// A key of a kind's scenario file, and everything that depends on it. A function is left empty if
// it does not apply to the key.
struct Key {
  std::string name;   // in the file
  std::string value;  // possible values for the reference page: "whole number"; empty with `below`
  std::string about;  // its meaning, as a phrase

  // Reads the key or, if it is absent, sets the default. Called in the keys' order. Throws
  // InputError.
  std::function<void(TopReader&)> read = {};
  // Checks the key once all keys have been read and fit together. Throws InputError.
  std::function<void(TopReader&)> verify = {};
  // Its lines in effective.yaml; reading them back gives the same experiment.
  std::function<std::string()> text = {};
  // Settings to name in a message if a results folder has rows of games with other settings.
  std::function<TextByPath()> values = {};
  // Names of those entries of the key that have games of their own, which depend on no other entry.
  // Such entries may be added to or removed from a folder with rows.
  std::function<std::vector<std::string>()> entries = {};
  // The teams that play, with their paths.
  std::function<std::vector<TeamAt>()> teams = {};
  // --pairs and --seed.
  int* pairs = nullptr;
  std::function<std::optional<std::uint64_t>()> seed = {};
  std::function<void(std::uint64_t)> set_seed = {};
  std::function<std::string()> seed_text = {};
  std::function<KeysBelow()> below = {};
  // Settings shared by all games.
  game::GameSettings* base = nullptr;
};

// `base`, with the teams that play all games and without the settings of the experiment's factors.
Key base_key(game::GameSettings& base, std::function<std::vector<Factor>()> factors);

// `base` without teams; `remedy` says where the teams are listed.
Key base_without_teams_key(game::GameSettings& base, std::string remedy,
                           std::string about = "shared by every game");

// Teams by name, with the base's settings as defaults.
Key teams_key(const std::string& name, std::string about, Teams& teams, game::GameSettings& base,
              TeamCount count = {});

// `base` and `teams` of an experiment between named teams.
Key base_key(NamedTeams& named);
Key teams_key(NamedTeams& named, std::string about, TeamCount count = {});

Key pairs_key(int& pairs, std::string about);
Key seed_key(std::uint64_t& seed);

// `set_by_values`, which AutoRef writes into effective.yaml: the settings that each value of the
// factors sets. A file in which they have been changed is refused.
Key set_by_values_key(const game::GameSettings& base, std::function<std::vector<Factor>()> factors);

// The values of all settings except aliases.
TextByPath values_of(const std::vector<game::Setting>& settings);

}  // namespace autoref::experiments
