// Reads teams that have names of their own. For experiment readers.
#pragma once

#include <cstdint>
#include <string>

#include "runner/experiments/named_teams.hpp"
#include "runner/settings/assignments.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// How many teams an experiment may have.
struct TeamCount {
  std::size_t least = 2;
  std::size_t most = SIZE_MAX;
};

class NamedTeamsReader {
 public:
  // All must outlive the reader; the places of the teams' settings go into `locations`.
  // Assignments to teams.NAME. stand over the file.
  NamedTeamsReader(const YamlFile& file, SettingLocations& locations,
                   const Assignments& assignments)
      : file_(file), locations_(locations), assignments_(assignments) {}

  // Adds the teams of an entry, and to `base`, which has been read, the types they name. Throws
  // InputError, also for fewer or more teams than these.
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
