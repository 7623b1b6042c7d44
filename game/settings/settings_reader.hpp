// Reads the settings in scenarios, scenes and robot types.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "game/settings/fields.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::game {

// Locations of settings in the file, by path.
using SettingLocations = std::map<std::string, YamlLocation>;

// Returns the location of the setting at `path`, or of the first one below that branch; {} if the
// file has neither.
YamlLocation location_in(const SettingLocations& locations, const std::string& path);

// Returns the entry of a required key. Throws InputError if it is missing.
const YamlEntry& required_entry(const YamlFile& file, const std::vector<YamlEntry>& top,
                                std::string_view key);

// Throws InputError unless the key is present and has this value.
void expect_value(const YamlFile& file, const std::vector<YamlEntry>& top, std::string_view key,
                  const std::string& value);

// Throws InputError if there is an entry with another key.
void refuse_unknown(const YamlFile& file, const std::vector<YamlEntry>& top,
                    const std::vector<std::string>& known);

// Reads a file with `schema`, `kind` and perhaps `about`, whose other keys are the top-level names
// of the settings. Returns those that it has. Throws InputError.
std::vector<std::string> read_settings_file(const YamlFile& file, const std::string& kind,
                                            std::vector<Setting> settings);

// Parses the entry's value into the setting. Throws InputError saying what was expected.
void assign_entry(const YamlFile& file, const YamlEntry& entry, const Setting& setting);

// Reads branches of a file into a game as strictly as `--set`. Records the locations of the
// settings and which of them are given. Does not check whether settings contradict each other.
class SettingsReader {
 public:
  using List = std::function<std::vector<Setting>()>;

  // All three arguments must outlive the reader. Settings are stored in `game`, their locations in
  // `locations`.
  SettingsReader(const YamlFile& file, GameSettings& game, SettingLocations& locations)
      : SettingsReader(
            file, [&game] { return settings_of(game); }, game, locations) {}

  // Reads the settings returned by `list`, which is called again after each new player or type.
  // Types and presets read from files, and the given settings, are added to `game`.
  SettingsReader(const YamlFile& file, List list, GameSettings& game, SettingLocations& locations)
      : file_(file),
        list_(std::move(list)),
        types_(&game.types),
        given_(&game.given),
        settings_(list_()),
        locations_(locations) {}

  // Reads only these settings, which must not accept files (measured_presets.hpp) or include
  // players or types.
  SettingsReader(const YamlFile& file, std::vector<Setting> settings, SettingLocations& locations)
      : file_(file), settings_(std::move(settings)), locations_(locations) {}

  // Treats a setting, or a branch of settings, as unknown.
  void hide(std::string_view path);

  // The top-level names of the settings.
  std::vector<std::string> names() const { return names_below(settings_, ""); }

  // unknown_key_message(), followed by other places where the settings have a key of that name.
  std::string about_unknown(std::string_view key, const std::vector<std::string>& known) const;

  // Reads the setting, or branch of settings, at `path`. Throws InputError.
  void read(const YamlEntry& entry, const std::string& path);

 private:
  bool is_hidden(const Setting& setting) const;
  void rebuild_list();
  void read_branch(const YamlEntry& branch, const std::string& path);
  void refuse_handicap_beside_its_factors(const std::vector<YamlEntry>& entries,
                                          const std::string& path) const;
  void read_held(const YamlEntry& entry, const Setting& setting);
  void read_players(const YamlEntry& entry, const std::string& path, Players& players);
  template <typename ByName>
  void read_named(const YamlEntry& entry, const std::string& path, ByName& all,
                  std::string_view what);
  void read_file_or_name(const YamlEntry& entry, const Setting& setting);
  void read_value(const YamlEntry& entry, const Setting& setting);

  const YamlFile& file_;
  List list_;
  RobotTypes* types_ = nullptr;
  std::set<std::string>* given_ = nullptr;
  std::vector<std::string> hidden_;
  std::vector<Setting> settings_;
  SettingLocations& locations_;
};

}  // namespace autoref::game
