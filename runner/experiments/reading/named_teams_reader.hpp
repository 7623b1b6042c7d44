// Reads named teams, for the readers of experiments.
#pragma once

#include <cstdint>
#include <string>

#include "runner/experiments/named_teams.hpp"
#include "runner/settings/assignments.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

class NamedTeamsReader {
 public:
  // All must outlive the reader. Records the locations of the teams' settings in `locations`.
  // Assignments to teams.NAME. override the file.
  NamedTeamsReader(const YamlFile& file, SettingLocations& locations,
                   const Assignments& assignments)
      : file_(file), locations_(locations), assignments_(assignments) {}

  // Adds the entry's teams to `teams`, and the robot types that these teams use to `base`, which
  // must already have been read. Throws InputError, also if the number of teams is outside `count`.
  void read(const YamlEntry& entry, Teams& teams, GameSettings& base, TeamCount count) const;

 private:
  void read_team(const YamlEntry& entry, const std::string& branch, Teams& teams,
                 GameSettings& base) const;

  void assign(const std::string& path, TeamSettings& team, GameSettings& base) const;
  void refuse_other_teams(const std::string& branch, const Teams& teams) const;

  const YamlFile& file_;
  SettingLocations& locations_;
  const Assignments& assignments_;
};

}  // namespace autoref::runner
