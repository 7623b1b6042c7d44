// Reads the branches of a scenario that hold settings. For scenario.cpp.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runner/fields.hpp"
#include "runner/yaml.hpp"

namespace autoref::runner {

// Where settings stand in the file, by path.
using Places = std::map<std::string, YamlPlace>;

class SettingsReader {
 public:
  // All three must outlive the reader; settings go into `game`, their places into `places`.
  SettingsReader(const YamlFile& file, GameConfiguration& game, Places& places)
      : file_(file), settings_(settings_of(game)), places_(places) {}

  // Makes a setting unknown.
  void hide(std::string_view path);

  // The names at the top of the tree of settings.
  std::vector<std::string> names() const { return names_below(settings_, ""); }

  // Reads a setting, or the branch of settings, at `path`. Throws InputError.
  void read(const YamlEntry& entry, const std::string& path);

 private:
  const Setting* find(const std::string& path) const;
  void read_branch(const YamlEntry& branch, const std::string& path);
  void refuse_handicap_beside_its_factors(const std::vector<YamlEntry>& entries,
                                          const std::string& path) const;
  void read_params(const YamlEntry& entry, const Setting& setting,
                   std::map<std::string, double>& params);
  void read_value(const YamlEntry& entry, const Setting& setting);

  const YamlFile& file_;
  std::vector<Setting> settings_;
  Places& places_;
};

}  // namespace autoref::runner
