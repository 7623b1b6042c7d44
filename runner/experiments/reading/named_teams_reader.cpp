#include "runner/experiments/reading/named_teams_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

std::string team_count_text(const TeamCount& count) {
  if (count.least == 1) return "at least one team";
  if (count.most == SIZE_MAX) return fmt::format("at least {} teams", count.least);
  if (count.least == count.most) return fmt::format("{} teams", count.least);
  return fmt::format("{} to {} teams", count.least, count.most);
}

}  // namespace

void NamedTeamsReader::read(const YamlEntry& entry, Teams& teams, GameSettings& base,
                            TeamCount count) const {
  for (const YamlEntry& team : file_.entries(entry, entry.key, {})) {
    read_team(team, entry.key, teams, base);
  }
  refuse_other_teams(entry.key, teams);
  if (count.least <= teams.size() && teams.size() <= count.most) return;
  file_.refuse(entry.location, entry.key,
               fmt::format("expected {}, such as zone: {{ strategy: basic }}, found {}",
                           team_count_text(count), teams.size()));
}

void NamedTeamsReader::read_team(const YamlEntry& entry, const std::string& branch, Teams& teams,
                                 GameSettings& base) const {
  try {
    check_team_name(entry.key);
  } catch (const std::invalid_argument& error) {
    file_.refuse(entry.location, branch, error.what());
  }
  // The base's rules determine the default number of robots.
  TeamSettings& team = teams[entry.key] = base.a;
  const std::string path = fmt::format("{}.{}", branch, entry.key);
  locations_[path] = entry.location;
  const auto list = [&team, &base, prefix = path + "."] {
    return settings_of(team, base.types, prefix);
  };
  SettingsReader(file_, list, base, locations_).read(entry, path);
  assign(path, team, base);
}

void NamedTeamsReader::assign(const std::string& path, TeamSettings& team,
                              GameSettings& base) const {
  for (const Assignment& assignment : assignments_) {
    const std::string its_path = full_path(assignment.path);
    if (!its_path.starts_with(path + ".")) continue;
    blame(assignment.flag, [&] {
      set_by_path({base, team, path + "."}, its_path, assignment.value);
    });
  }
}

void NamedTeamsReader::refuse_other_teams(const std::string& branch, const Teams& teams) const {
  std::vector<std::string> known;
  for (const auto& [name, team] : teams) known.push_back(fmt::format("{}.{}", branch, name));
  for (const Assignment& assignment : assignments_) {
    const std::string full = full_path(assignment.path);
    if (!full.starts_with(branch + ".")) continue;
    const std::string path = full.substr(0, full.find('.', branch.size() + 1));
    if (std::find(known.begin(), known.end(), path) != known.end()) continue;
    throw InputError({assignment.flag}, "", unknown_key_message(path, known));
  }
}

}  // namespace autoref::runner
