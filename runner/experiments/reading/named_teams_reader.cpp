#include "runner/experiments/reading/named_teams_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace autoref::runner {
namespace {

std::string text_of(const TeamCount& count) {
  if (count.least == 1) return "at least one team";
  if (count.most == SIZE_MAX) return fmt::format("at least {} teams", count.least);
  if (count.least == count.most) return fmt::format("{} teams", count.least);
  return fmt::format("{} to {} teams", count.least, count.most);
}

}  // namespace

void NamedTeamsReader::read(const YamlEntry& entry, Teams& teams, GameConfiguration& base,
                            TeamCount count) const {
  for (const YamlEntry& team : file_.entries(entry, entry.key, {})) {
    read_team(team, entry.key, teams, base);
  }
  if (count.least <= teams.size() && teams.size() <= count.most) return;
  file_.refuse(entry.location, entry.key,
               fmt::format("expected {}, such as zone: {{ strategy: basic }}, found {}",
                           text_of(count), teams.size()));
}

void NamedTeamsReader::read_team(const YamlEntry& entry, const std::string& branch, Teams& teams,
                                 GameConfiguration& base) const {
  try {
    check_team_name(entry.key);
  } catch (const std::invalid_argument& error) {
    file_.refuse(entry.location, branch, error.what());
  }
  // The base's rules tell how many robots a team has.
  TeamConfiguration& team = teams[entry.key] = base.a;
  const std::string path = fmt::format("{}.{}", branch, entry.key);
  locations_[path] = entry.location;
  const auto list = [&team, &base, prefix = path + "."] {
    return settings_of(team, base.types, prefix);
  };
  SettingsReader(file_, list, base.types, locations_).read(entry, path);
}

}  // namespace autoref::runner
