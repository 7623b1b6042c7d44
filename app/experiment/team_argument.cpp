#include "app/experiment/team_argument.hpp"

#include <fmt/format.h>

#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "game/settings/command_text.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/named_files.hpp"
#include "game/settings/yaml.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"
#include "strategies/registry.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestTeamName = 40;

std::vector<std::string> names_of_teams() {
  std::vector<std::string> names;
  for (const strategies::Entry& entry : strategies::all_strategies())
    names.emplace_back(entry.name);
  return names;
}

// Whether the key is that of a setting, or a group of settings, of a team.
bool is_team_key(const std::string& key) {
  game::TeamSettings team;
  const std::vector<game::Setting> settings = game::settings_of(team, {}, "");
  return std::any_of(settings.begin(), settings.end(), [&key](const game::Setting& setting) {
    return setting.path == key || setting.path.starts_with(key + ".");
  });
}

// Reads the settings in a file of a team.
class TeamFile {
 public:
  explicit TeamFile(const std::string& file) : file_(io::read_user_file(file), file), name_(file) {}

  game::Assignments read() {
    std::vector<game::YamlEntry> entries = file_.top();
    if (game::find_entry(entries, "kind") != nullptr) {
      throw io::InputError({name_}, "kind",
                           "this is a scenario; give a file with the settings of one team, such "
                           "as: strategy: basic");
    }
    if (entries.size() == 1 && !is_team_key(entries.front().key)) {
      if (const std::vector<game::YamlEntry> team = team_below(entries.front()); !team.empty())
        entries = team;
    }
    for (const game::YamlEntry& entry : entries) add(entry, entry.key);
    if (settings_.empty()) {
      throw io::InputError({name_}, "", "expected settings of a team, such as: strategy: basic");
    }
    return settings_;
  }

 private:
  // The settings below a key that is the team's name. Returns an empty list if they are not a
  // team's settings.
  std::vector<game::YamlEntry> team_below(const game::YamlEntry& name) const {
    if (!name.value.IsMap()) return {};
    std::vector<game::YamlEntry> entries = file_.entries(name, name.key, {});
    const bool is_team = std::any_of(entries.begin(), entries.end(),
                                     [](const auto& entry) { return is_team_key(entry.key); });
    return is_team ? entries : std::vector<game::YamlEntry>();
  }

  void add(const game::YamlEntry& entry, const std::string& path) {
    if (entry.value.IsMap()) {
      for (const game::YamlEntry& part : file_.entries(entry, path, {}))
        add(part, path + "." + part.key);
      return;
    }
    std::string value = entry.value.IsSequence() ? game::text_of_command(file_.words(entry, path))
                                                 : file_.scalar(entry, path, "a value", false);
    if (path.ends_with("type") && game::is_settings_file(value) && fs::path(value).is_relative())
      value = fs::absolute(file_.folder() / value).string();
    settings_.push_back({fmt::format("{}:{}", name_, entry.location.line), path, value});
  }

  game::YamlFile file_;
  std::string name_;
  game::Assignments settings_;
};

bool is_executable(const fs::path& file) { return access(file.c_str(), X_OK) == 0; }

// Whether one of the folders in PATH has the program.
bool is_in_search_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  if (path == nullptr) return true;  // the system then searches folders of its own
  std::istringstream folders(path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_executable(fs::path(folder) / program)) return true;
  return false;
}

// The text, which is a command with arguments; empty if it is a single word.
std::string command_with_arguments(const std::string& text, const std::string& place) {
  std::vector<std::string> words;
  game::locate_errors(place, [&] { words = game::words_of_command(text); });
  if (text.find(' ') == std::string::npos) return {};
  // A program with a folder may be relative to the setting `directory`.
  const bool is_name = words.front().find('/') == std::string::npos;
  if (!is_name || is_in_search_path(words.front())) return text;
  throw io::InputError(
      {place}, "",
      fmt::format("cannot find the program '{}' of the command '{}' in the folders "
                  "of PATH",
                  words.front(), text));
}

// The command that plays a team that is a program; empty if the text names none.
std::string command_in(const std::string& text, const std::string& place) {
  std::error_code none;
  if (!fs::is_regular_file(text, none)) return command_with_arguments(text, place);
  const std::string file = text.find('/') == std::string::npos ? "./" + text : text;
  if (is_executable(file)) return game::text_of_command({file});
  if (text.ends_with(".py")) return game::text_of_command({"python3", file});
  throw io::InputError({place}, "",
                       fmt::format("{} is not executable; give the command that runs it, in "
                                   "quotes, such as 'node {}'",
                                   text, text));
}

[[noreturn]] void refuse_team(const std::string& text, const std::string& place) {
  const bool is_path = text.find('/') != std::string::npos || !fs::path(text).extension().empty();
  throw io::InputError(
      {place}, "",
      fmt::format("{} '{}'; expected a team that autoref show teams lists, a file, or a command in "
                  "quotes{}",
                  is_path ? "cannot find the file" : "unknown team", text,
                  io::suggestion(text, names_of_teams())));
}

// A name of letters, digits and underscores, from the last word that is not an option, without its
// folder and extension.
std::string name_in(const std::string& text) {
  std::string name;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (!word.starts_with('-') && !word.starts_with('\'')) name = fs::path(word).stem().string();
  for (char& c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!is_letter && !(c >= '0' && c <= '9')) c = '_';
  }
  return name.empty() ? "team" : name.substr(0, kLongestTeamName);
}

}  // namespace

TeamArgument team_argument(const std::string& given, const std::string& place) {
  const std::string text(io::trimmed(given));
  TeamArgument team{text, name_in(text), {}};
  if (strategies::find_strategy(text) != nullptr) {
    team.settings = {{place, "strategy", text}};
  } else if (text.ends_with(".yaml") || text.ends_with(".yml")) {
    team.settings = TeamFile(text).read();
  } else if (const std::string command = command_in(text, place); !command.empty()) {
    team.settings = {{place, "command", command}};
  } else {
    refuse_team(text, place);
  }
  return team;
}

}  // namespace autoref::app
