#include "experiments/reading/named_teams_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/schedule/team_versions.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

bool is_letter_of_names(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string team_count_text(const TeamCount& count) {
  if (count.most == 1) return "one team";
  if (count.least == 1) return "at least one team";
  if (count.most == SIZE_MAX) return fmt::format("at least {} teams", count.least);
  if (count.least == count.most) return fmt::format("{} teams", count.least);
  return fmt::format("{} to {} teams", count.least, count.most);
}

}  // namespace

void check_name(const game::YamlFile& file, const game::YamlEntry& entry, std::string_view branch,
                std::string_view noun) {
  const std::string& name = entry.key;
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), is_letter_of_names);
  if (is_word && name.find("-p") == std::string::npos) return;
  file.refuse(entry.location, branch,
              fmt::format("a {}'s name must consist of letters, digits, - and _, without '-p', "
                          "which marks the pair in a game's id (write _p); found '{}'",
                          noun, name));
}

void NamedTeamsReader::read(const game::YamlEntry& entry, Teams& teams, game::GameSettings& base,
                            TeamCount count) const {
  for (const game::YamlEntry& team : file_.entries(entry, entry.key, {})) {
    read_team(team, entry.key, teams, base);
  }
  refuse_other_teams(entry.key, teams);
  if (count.least <= teams.size() && teams.size() <= count.most) return;
  file_.refuse(entry.location, entry.key,
               fmt::format("expected {}, such as zone: {{ strategy: basic }}, found {}",
                           team_count_text(count), teams.size()));
}

void NamedTeamsReader::read_team(const game::YamlEntry& entry, const std::string& branch,
                                 Teams& teams, game::GameSettings& base) const {
  check_name(file_, entry, branch, "team");
  // The base's rules determine the default number of robots.
  game::TeamSettings& team = teams[entry.key] = base.a;
  const std::string path = fmt::format("{}.{}", branch, entry.key);
  locations_[path] = entry.location;
  if (!more_) refuse_version(entry, path);
  const auto list = [&, prefix = path + "."] {
    std::vector<game::Setting> settings = game::settings_of(team, base.types, prefix);
    if (!more_) return settings;
    for (game::Setting& setting : more_(entry.key, prefix)) settings.push_back(std::move(setting));
    return settings;
  };
  game::SettingsReader(file_, list, base, locations_).read(entry, path);
  assign(path, team, base);
}

void NamedTeamsReader::refuse_version(const game::YamlEntry& entry, const std::string& path) const {
  if (!entry.value.IsMap()) return;
  for (const game::YamlEntry& key : file_.entries(entry, path, {})) {
    if (key.key != kVersion && key.key != kVersionOf) continue;
    file_.refuse(key.location, path + "." + key.key,
                 "only the teams of a roundrobin and the challengers of a gauntlet are rated over "
                 "time; leave it out");
  }
}

void NamedTeamsReader::assign(const std::string& path, game::TeamSettings& team,
                              game::GameSettings& base) const {
  for (const game::Assignment& assignment : assignments_) {
    const std::string its_path = game::full_path(assignment.path);
    if (!its_path.starts_with(path + ".")) continue;
    if (more_ && (its_path == path + "." + kVersion || its_path == path + "." + kVersionOf))
      throw io::InputError(
          {assignment.flag}, "",
          fmt::format("{} and {} can only be set in the file", kVersion, kVersionOf));
    game::locate_errors(assignment.flag, [&] {
      game::set_by_path({base, team, path + "."}, its_path, assignment.value);
    });
  }
}

void NamedTeamsReader::refuse_other_teams(const std::string& branch, const Teams& teams) const {
  std::vector<std::string> known;
  for (const auto& [name, team] : teams) known.push_back(fmt::format("{}.{}", branch, name));
  for (const game::Assignment& assignment : assignments_) {
    const std::string full = game::full_path(assignment.path);
    if (!full.starts_with(branch + ".")) continue;
    const std::string path = full.substr(0, full.find('.', branch.size() + 1));
    if (std::find(known.begin(), known.end(), path) != known.end()) continue;
    throw io::InputError({assignment.flag}, "", game::unknown_key_message(path, known));
  }
}

}  // namespace autoref::experiments
