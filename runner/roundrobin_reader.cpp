#include "runner/roundrobin_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace autoref::runner {

void RoundRobinReader::read(const YamlEntry& teams, RoundRobin& robin) const {
  for (const YamlEntry& entry : file_.entries(teams, "teams", {})) read_team(entry, robin);
  if (robin.teams.size() >= 2) return;
  file_.refuse(teams.place, "teams",
               fmt::format("expected at least two teams, such as zone: {{ strategy: basic }}, "
                           "found {}",
                           robin.teams.size()));
}

void RoundRobinReader::read_team(const YamlEntry& entry, RoundRobin& robin) const {
  try {
    check_team_name(entry.key);
  } catch (const std::invalid_argument& error) {
    file_.refuse(entry.place, "teams", error.what());
  }
  // The base's rules tell how many robots a team has.
  TeamConfiguration& team = robin.teams[entry.key] = robin.base.a;
  const std::string path = "teams." + entry.key;
  places_[path] = entry.place;
  RobotTypes& types = robin.base.types;
  const auto list = [&team, &types, prefix = path + "."] {
    return settings_of(team, types, prefix);
  };
  SettingsReader(file_, list, types, places_).read(entry, path);
}

}  // namespace autoref::runner
