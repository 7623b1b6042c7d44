// Settings that vary between the games of an experiment.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/settings/game_settings.hpp"
#include "game/settings/setting_value.hpp"

namespace autoref::experiments {

// A setting by its short path ("b.handicap"), and its values. The first value is the baseline.
struct Factor {
  std::string path;
  std::vector<game::SettingValue> values;
  bool operator==(const Factor&) const = default;
};

// The factor's values as numbers; nullopt if one of them is a word.
std::optional<std::vector<double>> numbers_of(const Factor& factor);

// All combinations of the factors' values; the last factor changes fastest.
std::vector<std::vector<game::SettingValue>> combinations(const std::vector<Factor>& factors);

// The settings of `base` with each factor set to one value. Throws SettingError if the values
// contradict each other.
game::GameSettings configured(const game::GameSettings& base, const std::vector<Factor>& factors,
                              const std::vector<game::SettingValue>& values);

// The settings implied by presets and handicaps among the factors' values, except those the user
// set explicitly. Maps each value, such as "match.rules=2014", to settings by full path. All values
// of one factor set the same paths, and no two factors set the same path, so the values of a
// combination never conflict.
using SetByValues = std::map<std::string, std::map<std::string, std::string>>;
SetByValues set_by_values(const game::GameSettings& base, const std::vector<Factor>& factors);

}  // namespace autoref::experiments
