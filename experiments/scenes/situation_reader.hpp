// Reads one situation: positions given by hand or taken from a log.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/scenes/situation.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::experiments {

// The time in a log from which a situation is taken.
struct LoggedInstant {
  std::filesystem::path log;
  double at_s = 0;               // time in seconds from the start of the log
  Side attackers = Side::kWest;  // west is yellow
  double spread_m = 0;           // standard deviation added to every coordinate of a position
};

// Sets the situation's robots, ball and restart to those in the log, with positions rounded to 0.1
// mm. Robots with numbers too high for the size of the team get other numbers. Throws
// std::invalid_argument.
void take_from_log(const LoggedInstant& instant, const Field& field, int most_attackers,
                   int most_defenders, SituationSetup& situation);

// The permitted numbers of robots of each side in a situation.
struct SituationTeams {
  int attackers = kMaxRobots;
  int defenders = kMaxRobots;
};

class SituationReader {
 public:
  // All arguments must outlive the reader. `scene` contains the defaults for keys that the
  // situation does not set. Records the locations of situations and robots in `locations`.
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
