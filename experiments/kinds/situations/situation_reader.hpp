// Reads one situation: positions by hand, or from a log.
#pragma once

#include <string>

#include "experiments/kinds/situations/situation.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "soccer/field.hpp"

namespace autoref::experiments {

// The numbers of robots that each side of a situation may have.
struct SituationTeams {
  int attackers = kMaxRobots;
  int defenders = kMaxRobots;
};

class SituationReader {
 public:
  // All must outlive the reader. `scene` is what the situation does not say itself. Records the
  // locations of situations and robots in `locations`.
  SituationReader(const game::YamlFile& file, game::SettingLocations& locations, const Field& field,
                  const game::Scene& scene, const SituationTeams& teams)
      : file_(file), locations_(locations), field_(field), scene_(scene), teams_(teams) {}

  // Throws InputError.
  SituationSetup read(const game::YamlEntry& entry) const;

 private:
  void read_by_hand(const std::vector<game::YamlEntry>& entries, const std::string& path,
                    SituationSetup& situation) const;
  void read_restart(const std::vector<game::YamlEntry>& entries, const std::string& path,
                    SituationSetup& situation) const;
  void read_ball(const std::vector<game::YamlEntry>& entries, const std::string& path,
                 SituationSetup& situation) const;
  void read_robots(const game::YamlEntry& entry, const std::string& path,
                   std::vector<DrawnRobot>& robots) const;
  DrawnRobot read_robot(const game::YamlEntry& entry, const std::string& path) const;
  void read_log(const game::YamlEntry& entry, const std::string& path,
                SituationSetup& situation) const;
  std::string word(const game::YamlEntry& entry, const std::string& path,
                   const std::vector<std::string>& known) const;

  const game::YamlFile& file_;
  game::SettingLocations& locations_;
  const Field& field_;
  const game::Scene& scene_;
  const SituationTeams& teams_;
};

}  // namespace autoref::experiments
