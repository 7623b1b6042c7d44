#include "runner/settings_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace autoref::runner {

void SettingsReader::hide(std::string_view path) {
  std::erase_if(settings_, [path](const Setting& s) { return s.path == path; });
}

void SettingsReader::read(const YamlEntry& entry, const std::string& path) {
  const Setting* setting = find(path);
  if (setting == nullptr) {
    read_branch(entry, path);
  } else if (auto* params = std::get_if<std::map<std::string, double>*>(&setting->target)) {
    read_params(entry, *setting, **params);
  } else {
    read_value(entry, *setting);
  }
}

const Setting* SettingsReader::find(const std::string& path) const {
  const auto found = std::find_if(settings_.begin(), settings_.end(),
                                  [&](const Setting& s) { return s.path == path; });
  return found == settings_.end() ? nullptr : &*found;
}

void SettingsReader::read_branch(const YamlEntry& branch, const std::string& path) {
  const std::vector<std::string> known = names_below(settings_, path);
  const std::vector<YamlEntry> entries = file_.entries(branch, path, known);
  refuse_handicap_beside_its_factors(entries, path);
  // Single numbers change a preset's, wherever they stand beside it.
  const YamlEntry* preset = find_entry(entries, path == "sim" ? "camera" : "preset");
  if (preset != nullptr && find(path + "." + preset->key) != nullptr) {
    read(*preset, path + "." + preset->key);
  }
  for (const YamlEntry& entry : entries) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      file_.refuse(entry.place, path, unknown_key_message(entry.key, known));
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
    file_.refuse(handicap->place, path + ".handicap",
                 fmt::format("sets {} too; give one of the two", factor));
  }
}

void SettingsReader::read_params(const YamlEntry& entry, const Setting& setting,
                                 std::map<std::string, double>& params) {
  for (const YamlEntry& param : file_.entries(entry, setting.path, {})) {
    const std::string path = setting.path + "." + param.key;
    read_value(param, {path, &params[param.key], setting.range, {}, "", setting.about});
  }
}

void SettingsReader::read_value(const YamlEntry& entry, const Setting& setting) {
  places_[setting.path] = entry.place;
  try {
    assign(setting, file_.scalar(entry, setting.path, expected_of(setting), is_number(setting)));
  } catch (const std::invalid_argument& error) {
    file_.refuse(value_place(entry), setting.path, error.what());
  }
}

}  // namespace autoref::runner
