// Reads the keys specific to `kind: judge`.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "runner/experiments/judge_schedule.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

class JudgeReader {
 public:
  // Both must outlive the reader.
  JudgeReader(const YamlFile& file, SettingLocations& locations)
      : file_(file), locations_(locations) {}

  // Reads the rules, cameras, matchups or teams, and named seeds. Throws InputError.
  void read(const std::vector<YamlEntry>& top, JudgeSchedule& schedule) const;

 private:
  std::vector<std::string> values(const YamlEntry& entry, const std::string& path) const;
  // Refuses a file that has both keys.
  void refuse_both(const std::vector<YamlEntry>& top, const char* one, const char* other) const;
  void read_matchups(const YamlEntry& entry, JudgeSchedule& schedule) const;
  void read_seeds(const YamlEntry& entry, JudgeSchedule& schedule) const;
  NamedSeed seed_of(const YamlEntry& entry) const;
  std::array<std::string, 2> matchup_in(const YAML::Node& value) const;

  const YamlFile& file_;
  SettingLocations& locations_;
};

}  // namespace autoref::runner
