// Reads named teams, for the readers of experiments.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::experiments {

// Refuses the entry's name, which becomes part of game ids, unless it consists of letters, digits,
// - and _ and does not contain "-p", which marks the pair in an id. `branch` is the key with all
// the names, and `noun` says what the entry is: "team". Throws InputError.
void check_name(const game::YamlFile& file, const game::YamlEntry& entry, std::string_view branch,
                std::string_view noun);

// Further settings of the team of this name, which belong to the experiment rather than to its
// games. `prefix` is the path of the team's settings, such as "teams.mine.".
using MoreTeamSettings =
    std::function<std::vector<game::Setting>(const std::string& name, const std::string& prefix)>;

class NamedTeamsReader {
 public:
  // All arguments must outlive the reader. Records the locations of the teams' settings in
  // `locations`. Assignments to settings below teams.NAME override the file. Without `more`, a
  // team that is given a version is refused.
  NamedTeamsReader(const game::YamlFile& file, game::SettingLocations& locations,
                   const game::Assignments& assignments, MoreTeamSettings more = {})
      : file_(file), locations_(locations), assignments_(assignments), more_(std::move(more)) {}

  // Adds the entry's teams to `teams`, and the robot types that these teams use to `base`, which
  // must already have been read. Throws InputError, for example if the number of teams is outside
  // `count`.
  void read(const game::YamlEntry& entry, Teams& teams, game::GameSettings& base,
            TeamCount count) const;

 private:
  void read_team(const game::YamlEntry& entry, const std::string& branch, Teams& teams,
                 game::GameSettings& base) const;

  void refuse_version(const game::YamlEntry& entry, const std::string& path) const;
  void assign(const std::string& path, game::TeamSettings& team, game::GameSettings& base) const;
  void refuse_other_teams(const std::string& branch, const Teams& teams) const;

  const game::YamlFile& file_;
  game::SettingLocations& locations_;
  const game::Assignments& assignments_;
  const MoreTeamSettings more_;
};

}  // namespace autoref::experiments
