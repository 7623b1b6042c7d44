// Reads factors and lists of values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/experiments/factor.hpp"
#include "runner/settings/game_settings.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// Whether the schedule sets this value for each game. Neither base nor factors may set such a
// value.
bool is_decided_by_schedule(std::string_view path);
[[noreturn]] void refuse_decided(const YamlFile& file, const YamlLocation& location,
                                 std::string_view path);

class FactorReader {
 public:
  // Both must outlive the reader. Records the factors' locations in `locations`.
  FactorReader(const YamlFile& file, SettingLocations& locations)
      : file_(file), locations_(locations) {}

  // Adds the robot types that the factors name to `base`. Throws InputError.
  std::vector<Factor> read(const YamlEntry& factors, GameSettings& base);

  // Reads a list of distinct values of the setting at `path`. Adds the robot types named by these
  // values to `base`. Throws InputError.
  std::vector<SettingValue> values(const YamlEntry& list, const std::string& path,
                                   GameSettings& base) const;

 private:
  Factor read_factor(const YamlEntry& entry, GameSettings& base);
  SettingValue read_value(const YamlLocation& location, const std::string& path,
                          const std::string& text, GameSettings& base) const;
  // Refuses two keys that set the same number, since the later one would silently win.
  void refuse_overlap(const YamlEntry& entry, const std::vector<Factor>& factors,
                      const GameSettings& base) const;

  const YamlFile& file_;
  SettingLocations& locations_;
};

}  // namespace autoref::runner
