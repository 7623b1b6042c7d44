// Reads mappings whose keys are not settings of a game.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "game/settings/settings_branch.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "soccer/parameters.hpp"

namespace autoref::game {

// A mapping in which each key must be known and given at most once. All functions that read throw
// InputError.
class Mapping {
 public:
  Mapping(const YamlFile& file, const YamlEntry& entry, std::string path,
          const std::vector<std::string>& known)
      : file_(file), path_(std::move(path)), entries_(file.entries(entry, path_, known)) {
    for (const YamlEntry& key : entries_) {
      if (std::find(known.begin(), known.end(), key.key) != known.end()) continue;
      file_.refuse(key.location, path_, unknown_key_message(key.key, known));
    }
  }

  const YamlEntry* find(std::string_view key) const { return find_entry(entries_, key); }

  // These leave the value unchanged if the key is not given.
  void number(std::string_view key, double& value, Range range, std::string_view unit) const {
    read(key, {path_to(key), &value, range, {}, unit, ""});
  }
  // All parameters of `of`.
  template <HasParameters Of>
  void parameters(Of& of) const {
    Of::visit(of, [this](auto& value, const Parameter& about) {
      read(about.name, setting_of(path_to(about.name), value, about));
    });
  }
  void word(std::string_view key, std::string& value, std::vector<std::string> words) const {
    read(key, {path_to(key), &value, {}, std::move(words), "", ""});
  }
  void yes_or_no(std::string_view key, bool& value) const {
    std::string text = value ? "true" : "false";
    word(key, text, {"true", "false"});
    value = text == "true";
  }

  std::string path_to(std::string_view key) const { return fmt::format("{}.{}", path_, key); }

 private:
  void read(std::string_view key, const Setting& setting) const {
    const YamlEntry* entry = find(key);
    if (entry != nullptr) assign_entry(file_, *entry, setting);
  }

  const YamlFile& file_;
  std::string path_;
  std::vector<YamlEntry> entries_;
};

}  // namespace autoref::game
