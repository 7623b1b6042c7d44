// Reads an experiment's factors and their lists of values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/schedule/factor.hpp"
#include "game/settings/game_settings.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::experiments {

// Whether the schedule sets the setting at `path` for each game. Neither the base nor a factor may
// contain such a setting.
bool is_decided_by_schedule(std::string_view path);
[[noreturn]] void refuse_decided(const game::YamlFile& file, const game::YamlLocation& location,
                                 std::string_view path);

class FactorReader {
 public:
  // Both arguments must outlive the reader. Records the factors' locations in `locations`.
  FactorReader(const game::YamlFile& file, game::SettingLocations& locations)
      : file_(file), locations_(locations) {}

  // Reads the factors. Adds the robot types and presets that they give as files to `base`, and
  // applies the first value of each factor that is a preset of the whole game, since every game
  // replaces what the base has there, and effective.yaml leaves it out. Throws InputError.
  std::vector<Factor> read(const game::YamlEntry& factors, game::GameSettings& base);

  // Reads a list of distinct values of the setting at `path`. Adds the robot types and presets from
  // files among them to `base`. Throws InputError.
  std::vector<game::SettingValue> values(const game::YamlEntry& list, const std::string& path,
                                         game::GameSettings& base) const;

  // Parses one value of the setting at `path`. If it is a file, adds the robot type or preset in it
  // to `base`. Throws InputError.
  game::SettingValue value(const game::YamlLocation& location, const std::string& path,
                           const std::string& text, game::GameSettings& base) const;

 private:
  Factor read_factor(const game::YamlEntry& entry, game::GameSettings& base);
  // Refuses two keys that set the same value, since the later key would silently override the
  // earlier one.
  void refuse_overlap(const game::YamlEntry& entry, const std::vector<Factor>& factors,
                      const game::GameSettings& base) const;

  const game::YamlFile& file_;
  game::SettingLocations& locations_;
};

}  // namespace autoref::experiments
