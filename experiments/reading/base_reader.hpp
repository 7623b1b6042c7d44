// Reads `base:`, the settings shared by all games of an experiment.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::experiments {

// Reads types and rules first, since teams refer to types and rules set other branches; the order
// in the file does not matter. Keys that are not settings are ignored.
void read_settings(const std::vector<game::YamlEntry>& entries, game::SettingsReader& settings);

// A branch of settings that does not belong in `base`; `remedy` says where it belongs.
struct Elsewhere {
  std::string branch;
  std::string remedy;
};

class BaseReader {
 public:
  // Both must outlive the reader. Records the settings' locations in `locations`.
  BaseReader(const game::YamlFile& file, game::SettingLocations& locations,
             Elsewhere elsewhere = {})
      : file_(file), locations_(locations), elsewhere_(std::move(elsewhere)) {}

  // Throws InputError, also for settings decided by the schedule.
  void read(const game::YamlEntry& base, game::GameSettings& game) const;

 private:
  void refuse_misplaced(const game::YamlEntry& entry) const;
  void refuse_what_legs_decide(const game::YamlEntry& entry) const;

  const game::YamlFile& file_;
  game::SettingLocations& locations_;
  Elsewhere elsewhere_;
};

}  // namespace autoref::experiments
