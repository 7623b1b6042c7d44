#include "game/settings/settings_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <stdexcept>

#include "game/settings/command_text.hpp"
#include "game/settings/measured_presets.hpp"
#include "game/settings/named_files.hpp"
#include "io/words.hpp"

namespace autoref::game {

namespace {

// Name of the setting that sets other settings in this branch.
std::string_view name_of_preset_in(std::string_view branch) {
  if (branch == "sim") return "camera";
  return branch == "match" ? "rules" : kPresetName;
}

// An example of a line with this key, for keys with a format that is hard to guess.
std::string example_of(std::string_view key) {
  static const std::map<std::string_view, std::string_view> kExamples = {
      {"schema", "schema: 1"},
      {"kind", "kind: sweep"},
      {"factors", "factors: { b.handicap: [1.0, 0.9] }"},
      {"teams", "teams: { one: { strategy: basic }, other: { strategy: zone } }"},
      {"pairs", "pairs: 20"},
      {"games", "games: 20"},
      {"seed", "seed: 1"}};
  const auto found = kExamples.find(key);
  return found == kExamples.end() ? "" : fmt::format(", such as {}", found->second);
}

}  // namespace

const YamlEntry& required_entry(const YamlFile& file, const std::vector<YamlEntry>& top,
                                std::string_view key) {
  const YamlEntry* entry = find_entry(top, key);
  if (entry == nullptr) {
    file.refuse({1, 1}, "", fmt::format("the key '{}' is missing; add it{}", key, example_of(key)));
  }
  return *entry;
}

void expect_value(const YamlFile& file, const std::vector<YamlEntry>& top, std::string_view key,
                  const std::string& value) {
  const YamlEntry& entry = required_entry(file, top, key);
  const std::string text = file.scalar(entry, key, value, false);
  if (text == value) return;
  file.refuse(value_location(entry), key, fmt::format("expected {}, found '{}'", value, text));
}

void refuse_unknown(const YamlFile& file, const std::vector<YamlEntry>& top,
                    const std::vector<std::string>& known) {
  for (const YamlEntry& entry : top) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    file.refuse(entry.location, "", unknown_key_message(entry.key, known));
  }
}

std::vector<std::string> read_settings_file(const YamlFile& file, const std::string& kind,
                                            std::vector<Setting> settings) {
  const std::vector<YamlEntry> top = file.top();
  expect_value(file, top, "schema", "1");
  expect_value(file, top, "kind", kind);
  const std::vector<std::string> names = names_below(settings, "");
  std::vector<std::string> known = {"schema", "kind", "about"};
  known.insert(known.end(), names.begin(), names.end());
  refuse_unknown(file, top, known);
  if (const YamlEntry* about = find_entry(top, "about")) {
    file.scalar(*about, "about", "a sentence", false);
  }
  SettingLocations locations;
  SettingsReader reader(file, std::move(settings), locations);
  std::vector<std::string> given;
  for (const std::string& name : names) {
    const YamlEntry* entry = find_entry(top, name);
    if (entry == nullptr) continue;
    reader.read(*entry, name);
    given.push_back(name);
  }
  return given;
}

void assign_entry(const YamlFile& file, const YamlEntry& entry, const Setting& setting) {
  try {
    if (std::holds_alternative<CommandWords>(setting.target) && entry.value.IsSequence())
      return set_value(setting, text_of_command(file.words(entry, setting.path)));
    assign(setting, file.scalar(entry, setting.path, expected_of(setting), is_number(setting)));
  } catch (const std::invalid_argument& error) {
    file.refuse(value_location(entry), setting.path, error.what());
  }
}

YamlLocation location_in(const SettingLocations& locations, const std::string& path) {
  const auto found = locations.lower_bound(path);
  const bool is_there =
      found != locations.end() && (found->first == path || found->first.starts_with(path + "."));
  return is_there ? found->second : YamlLocation{};
}

void SettingsReader::hide(std::string_view path) {
  hidden_.emplace_back(path);
  std::erase_if(settings_, [this](const Setting& s) { return is_hidden(s); });
}

bool SettingsReader::is_hidden(const Setting& setting) const {
  return std::any_of(hidden_.begin(), hidden_.end(), [&setting](const std::string& path) {
    return setting.path == path || setting.path.starts_with(path + ".");
  });
}

// Lists the settings again after a player or type has been added.
void SettingsReader::rebuild_list() {
  assert(list_ != nullptr);
  settings_ = list_();
  std::erase_if(settings_, [this](const Setting& s) { return is_hidden(s); });
}

void SettingsReader::read(const YamlEntry& entry, const std::string& path) {
  const Setting* found = find_setting(settings_, path);
  if (found == nullptr) return read_branch(entry, path);
  const Setting setting = *found;  // a copy, since reading players and types rebuilds the list
  if (const auto* players = std::get_if<Players*>(&setting.target)) {
    read_players(entry, path, **players);
  } else if (const auto* types = std::get_if<RobotTypes*>(&setting.target)) {
    read_named(entry, path, **types, kRobotType);
  } else if (const auto* presets = std::get_if<MeasuredPresets*>(&setting.target)) {
    read_named(entry, path, **presets, kPreset);
  } else if (holds_others(setting)) {
    read_held(entry, setting);
  } else if (accepts_file(setting)) {
    read_file_or_name(entry, setting);
  } else {
    read_value(entry, setting);
  }
}

std::string SettingsReader::about_unknown(std::string_view key,
                                          const std::vector<std::string>& known) const {
  const std::vector<std::string> elsewhere = paths_ending_in(key, full_paths(settings_));
  return unknown_key_message(key, known) +
         (elsewhere.empty() ? "" : "; elsewhere: " + io::listed(elsewhere));
}

void SettingsReader::read_branch(const YamlEntry& branch, const std::string& path) {
  if (branch.value.IsScalar() && preset_of_branch(settings_, path) != nullptr) {
    return read(branch, preset_of_branch(settings_, path)->path);
  }
  const std::vector<std::string> known = names_below(settings_, path);
  const std::vector<YamlEntry> entries = file_.entries(branch, path, known);
  refuse_handicap_beside_its_factors(entries, path);
  // Read the preset first: single settings override it, wherever they appear.
  const YamlEntry* preset = find_entry(entries, name_of_preset_in(path));
  if (preset != nullptr && find_setting(settings_, path + "." + preset->key) != nullptr) {
    read(*preset, path + "." + preset->key);
  }
  for (const YamlEntry& entry : entries) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      file_.refuse(entry.location, path, about_unknown(entry.key, known));
    }
    if (&entry != preset) read(entry, path + "." + entry.key);
  }
}

void SettingsReader::refuse_handicap_beside_its_factors(const std::vector<YamlEntry>& entries,
                                                        const std::string& path) const {
  const YamlEntry* handicap = find_entry(entries, "handicap");
  if (handicap == nullptr) return;
  for (const char* factor : {"speed_factor", "acceleration_factor"}) {
    if (find_entry(entries, factor) == nullptr) continue;
    file_.refuse(handicap->location, path + ".handicap",
                 fmt::format("also sets {}; give only one of the two", factor));
  }
}

void SettingsReader::read_held(const YamlEntry& entry, const Setting& setting) {
  const std::vector<std::string> known = names_in(setting);
  if (entry.value.IsScalar()) {
    const std::optional<Setting> preset = preset_in(setting);
    if (preset) return read_value(entry, *preset);
  }
  const std::vector<YamlEntry> entries = file_.entries(entry, setting.path, known);
  const auto read_one = [&](const YamlEntry& held) {
    const std::optional<Setting> its_setting = setting_in(setting, held.key);
    if (!its_setting) {
      file_.refuse(held.location, setting.path, unknown_key_message(held.key, known));
    }
    read_value(held, *its_setting);
  };
  // Read the preset first: single settings override it, wherever they appear.
  const YamlEntry* preset = known.empty() ? nullptr : find_entry(entries, kPresetName);
  if (preset != nullptr) read_one(*preset);
  for (const YamlEntry& held : entries) {
    if (&held != preset) read_one(held);
  }
}

void SettingsReader::read_players(const YamlEntry& entry, const std::string& path,
                                  Players& players) {
  for (const YamlEntry& player : file_.entries(entry, path, {})) {
    try {
      player_of(players, player.key);
    } catch (const std::invalid_argument& error) {
      file_.refuse(player.location, path, error.what());
    }
    rebuild_list();
    const std::string its_path = path + "." + player.key;
    locations_[its_path] = player.location;
    read_branch(player, its_path);
  }
}

template <typename ByName>
void SettingsReader::read_named(const YamlEntry& entry, const std::string& path, ByName& all,
                                std::string_view what) {
  const std::vector<YamlEntry> entries = file_.entries(entry, path, {});
  for (const YamlEntry& one : entries) {
    if (const std::optional<std::string> fault = fault_in_name(one.key, what)) {
      file_.refuse(one.location, path, *fault);
    }
    try {
      all[one.key];
      check_name_count(all.size(), what);
    } catch (const std::invalid_argument& error) {
      file_.refuse(one.location, path, error.what());
    }
  }
  rebuild_list();
  for (const YamlEntry& one : entries) read_branch(one, path + "." + one.key);
}

void SettingsReader::read_file_or_name(const YamlEntry& entry, const Setting& setting) {
  assert(types_ != nullptr);
  const std::string text = file_.scalar(entry, setting.path, expected_of(setting), false);
  try {
    const SettingValue value = value_in(take_name(setting, text, file_.folder(), *types_), setting);
    if (!is_preset(setting)) return set_value(setting, value);
    locations_[setting.path] = entry.location;
    set_given(settings_, setting, value, *given_);
  } catch (const std::invalid_argument& error) {
    file_.refuse(value_location(entry), setting.path, error.what());
  }
}

void SettingsReader::read_value(const YamlEntry& entry, const Setting& setting) {
  locations_[setting.path] = entry.location;
  assign_entry(file_, entry, setting);
  if (given_ != nullptr && !is_preset(setting) && !is_alias(setting)) given_->insert(setting.path);
}

}  // namespace autoref::game
