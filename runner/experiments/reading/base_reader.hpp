// Reads `base:`, the settings shared by all games of an experiment.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// Reads types and rules first, since teams refer to types and rules set other branches; the order
// in the file does not matter. Keys that are not settings are ignored.
void read_settings(const std::vector<YamlEntry>& entries, SettingsReader& settings);

// A branch of settings that does not belong in `base`; `remedy` says where it belongs.
struct Elsewhere {
  std::string branch;
  std::string remedy;
};

class BaseReader {
 public:
  // Both must outlive the reader. Records the settings' locations in `locations`.
  BaseReader(const YamlFile& file, SettingLocations& locations, Elsewhere elsewhere = {})
      : file_(file), locations_(locations), elsewhere_(std::move(elsewhere)) {}

  // Throws InputError, also for settings decided by the schedule.
  void read(const YamlEntry& base, GameSettings& game) const;

 private:
  void refuse_misplaced(const YamlEntry& entry) const;
  void refuse_what_legs_decide(const YamlEntry& entry) const;

  const YamlFile& file_;
  SettingLocations& locations_;
  Elsewhere elsewhere_;
};

}  // namespace autoref::runner
