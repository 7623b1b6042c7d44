// The keys of scenario files, as the kinds of experiments list them.
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

// A team of a key.
struct TeamAt {
  std::string path;  // "teams.bold"
  game::TeamSettings* team = nullptr;
};

// A row of the reference page: one or several keys, what they may be, and what they mean. Names of
// keys and values are between backticks.
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

// A row for each setting, by its last name, with what it may be and its present value, which is the
// default in a new experiment. Those in `required` have no default.
std::vector<KeyRow> rows_of(const std::vector<game::Setting>& settings,
                            const std::vector<std::string>& required = {});

// A key of a kind's scenario file, and everything that depends on it. A function that is not set
// means that the key has nothing of the sort.
struct Key {
  std::string name;   // in the file
  std::string value;  // what it may be, for the reference page: "whole number"; empty with `below`
  std::string about;  // what it means, a phrase

  // Reads the key, or what its absence means. Called in the keys' order. Throws InputError.
  std::function<void(TopReader&)> read = {};
  // Checks the key once all keys have been read and fit together. Throws InputError.
  std::function<void(TopReader&)> verify = {};
  // Its lines in effective.yaml; reading them gives the same experiment again.
  std::function<std::string()> text = {};
  // Settings that a message names if a results folder has rows of games with other ones.
  std::function<TextByPath()> values = {};
  // Names of the key's entries whose games depend on no other entry. A folder with rows may gain or
  // lose such entries.
  std::function<std::vector<std::string>()> entries = {};
  // Teams that play, by path.
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

// `base`, with the teams that play all games, except what the experiment's factors set.
Key base_key(game::GameSettings& base, std::function<std::vector<Factor>()> factors);

// `base` without teams; `remedy` says where those are listed.
Key base_without_teams_key(game::GameSettings& base, std::string remedy,
                           std::string about = "of every game");

// Teams by name, with the base's settings as defaults.
Key teams_key(const std::string& name, std::string about, Teams& teams, game::GameSettings& base,
              TeamCount count = {});

// `base` and `teams` of an experiment between named teams.
Key base_key(NamedTeams& named);
Key teams_key(NamedTeams& named, std::string about, TeamCount count = {});

Key pairs_key(int& pairs, std::string about);
Key seed_key(std::uint64_t& seed);

// `set_by_values`, which AutoRef writes into effective.yaml: the settings that each value of the
// factors sets. Refuses a file in which they have been changed.
Key set_by_values_key(const game::GameSettings& base, std::function<std::vector<Factor>()> factors);

// The values of all settings except aliases.
TextByPath values_of(const std::vector<game::Setting>& settings);

}  // namespace autoref::experiments
