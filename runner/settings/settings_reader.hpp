// Reads the parts of a file that hold settings: of scenarios, scenes and types of robots.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "runner/settings/fields.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// Where settings stand in the file, by path.
using SettingLocations = std::map<std::string, YamlLocation>;

// The entry of a key that must be there. Throws InputError.
const YamlEntry& required_entry(const YamlFile& file, const std::vector<YamlEntry>& top,
                                std::string_view key);

// Throws InputError unless the key is there and has this value.
void expect_value(const YamlFile& file, const std::vector<YamlEntry>& top, std::string_view key,
                  const std::string& value);

// Throws InputError for an entry with another key.
void refuse_unknown(const YamlFile& file, const std::vector<YamlEntry>& top,
                    const std::vector<std::string>& known);

// Reads the entry's value into the setting. Throws InputError that says what was expected.
void assign_entry(const YamlFile& file, const YamlEntry& entry, const Setting& setting);

// Puts branches of a file into a game as strictly as `--set` would, and remembers their locations
// and which settings are given. What settings mean together is not checked here.
class SettingsReader {
 public:
  using List = std::function<std::vector<Setting>()>;

  // All three must outlive the reader; settings go into `game`, their places into `locations`.
  SettingsReader(const YamlFile& file, GameConfiguration& game, SettingLocations& locations)
      : SettingsReader(
            file, [&game] { return settings_of(game); }, game, locations) {}

  // Reads the settings that `list` returns, which is called again whenever there are new players or
  // types; files of types that they name, and what is given, go into `game`.
  SettingsReader(const YamlFile& file, List list, GameConfiguration& game,
                 SettingLocations& locations)
      : file_(file),
        list_(std::move(list)),
        types_(&game.types),
        given_(&game.given),
        settings_(list_()),
        locations_(locations) {}

  // Reads just these settings, none of which may name a type, players or types.
  SettingsReader(const YamlFile& file, std::vector<Setting> settings, SettingLocations& locations)
      : file_(file), settings_(std::move(settings)), locations_(locations) {}

  // Makes a setting, or a branch of settings, unknown.
  void hide(std::string_view path);

  // The names at the top of the tree of settings.
  std::vector<std::string> names() const { return names_below(settings_, ""); }

  // Reads a setting, or the branch of settings, at `path`. Throws InputError.
  void read(const YamlEntry& entry, const std::string& path);

 private:
  bool is_hidden(const Setting& setting) const;
  void list_anew();
  void read_branch(const YamlEntry& branch, const std::string& path);
  void refuse_handicap_beside_its_factors(const std::vector<YamlEntry>& entries,
                                          const std::string& path) const;
  void read_held(const YamlEntry& entry, const Setting& setting);
  void read_players(const YamlEntry& entry, const std::string& path, Players& players);
  void read_types(const YamlEntry& entry, const std::string& path, RobotTypes& types);
  void read_type(const YamlEntry& entry, const Setting& setting);
  void read_value(const YamlEntry& entry, const Setting& setting);

  const YamlFile& file_;
  List list_;
  RobotTypes* types_ = nullptr;
  std::set<std::string>* given_ = nullptr;
  std::vector<std::string> hidden_;
  std::vector<Setting> settings_;
  SettingLocations& locations_;
};

}  // namespace autoref::runner
