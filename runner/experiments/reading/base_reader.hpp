// Reads `base:`, what all games of an experiment have in common. For scenario.cpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// Reads settings in an order in which none undoes another: teams name types, and rules set other
// branches, wherever these stand beside them. Other keys than settings' are left alone.
void read_settings(const std::vector<YamlEntry>& entries, SettingsReader& settings);

// A branch of settings that stands elsewhere in a kind of file; `remedy` says where.
struct Elsewhere {
  std::string branch;
  std::string remedy;
};

class BaseReader {
 public:
  // Both must outlive the reader; the places of settings go into `locations`.
  BaseReader(const YamlFile& file, SettingLocations& locations, Elsewhere elsewhere = {})
      : file_(file), locations_(locations), elsewhere_(std::move(elsewhere)) {}

  // Throws InputError, also for what is decided by the plan.
  void read(const YamlEntry& base, GameSettings& game) const;

 private:
  void refuse_misplaced(const YamlEntry& entry) const;
  void refuse_what_legs_decide(const YamlEntry& entry) const;

  const YamlFile& file_;
  SettingLocations& locations_;
  Elsewhere elsewhere_;
};

}  // namespace autoref::runner
