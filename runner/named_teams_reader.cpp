#include "runner/named_teams_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace autoref::runner {
namespace {

std::string text_of(const TeamCount& count) {
  if (count.most == SIZE_MAX) return fmt::format("at least {} teams", count.least);
  if (count.least == count.most) return fmt::format("{} teams", count.least);
  return fmt::format("{} to {} teams", count.least, count.most);
}

}  // namespace

void NamedTeamsReader::read(const YamlEntry& teams, NamedTeams& named, TeamCount count) const {
  for (const YamlEntry& entry : file_.entries(teams, "teams", {})) read_team(entry, named);
  if (count.least <= named.teams.size() && named.teams.size() <= count.most) return;
  file_.refuse(teams.place, "teams",
               fmt::format("expected {}, such as zone: {{ strategy: basic }}, found {}",
                           text_of(count), named.teams.size()));
}

void NamedTeamsReader::read_team(const YamlEntry& entry, NamedTeams& named) const {
  try {
    check_team_name(entry.key);
  } catch (const std::invalid_argument& error) {
    file_.refuse(entry.place, "teams", error.what());
  }
  // The base's rules tell how many robots a team has.
  TeamConfiguration& team = named.teams[entry.key] = named.base.a;
  const std::string path = "teams." + entry.key;
  places_[path] = entry.place;
  RobotTypes& types = named.base.types;
  const auto list = [&team, &types, prefix = path + "."] {
    return settings_of(team, types, prefix);
  };
  SettingsReader(file_, list, types, places_).read(entry, path);
}

}  // namespace autoref::runner
