#include "experiments/reading/base_reader.hpp"

#include <algorithm>

#include "experiments/reading/factor_reader.hpp"

namespace autoref::experiments {

void read_settings(const std::vector<game::YamlEntry>& entries, game::SettingsReader& settings) {
  const std::vector<std::string> first = {"types", "match"};
  const std::vector<std::string> known = settings.names();
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& key : first) {
    if (const game::YamlEntry* entry = game::find_entry(entries, key)) settings.read(*entry, key);
  }
  for (const game::YamlEntry& entry : entries) {
    if (is_in(known, entry.key) && !is_in(first, entry.key)) settings.read(entry, entry.key);
  }
}

void BaseReader::read(const game::YamlEntry& base, game::GameSettings& game) const {
  game::SettingsReader settings(file_, game, locations_);
  settings.hide("seed");
  settings.hide(elsewhere_.branch);
  const std::vector<std::string> known = settings.names();
  const std::vector<game::YamlEntry> entries = file_.entries(base, "base", known);
  for (const game::YamlEntry& entry : entries) {
    refuse_misplaced(entry);
    refuse_what_legs_decide(entry);
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    file_.refuse(entry.location, "base", settings.about_unknown(entry.key, known));
  }
  read_settings(entries, settings);
}

void BaseReader::refuse_misplaced(const game::YamlEntry& entry) const {
  if (entry.key != elsewhere_.branch) return;
  file_.refuse(entry.location, "base." + entry.key, elsewhere_.remedy);
}

void BaseReader::refuse_what_legs_decide(const game::YamlEntry& entry) const {
  if (entry.key != "match" || !entry.value.IsMap()) return;
  for (const game::YamlEntry& key : file_.entries(entry, "match", {})) {
    const std::string path = "match." + key.key;
    if (is_decided_by_schedule(path)) refuse_decided(file_, key.location, path);
  }
}

}  // namespace autoref::experiments
