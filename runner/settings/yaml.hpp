// YAML with places: a thin layer over yaml-cpp that refuses what a strict reader must not pass.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::runner {

// Line and column in a file, counted from 1; 0 where there is none.
struct YamlLocation {
  int line = 0;
  int column = 0;
};

struct YamlEntry {
  std::string key;
  YamlLocation location;  // of the key
  YAML::Node value;
};

YamlLocation location_of(const YAML::Node& node);

// The value's place, the key's where there is no value.
YamlLocation value_location(const YamlEntry& entry);

// The entry of that key, nullptr where there is none.
const YamlEntry* find_entry(const std::vector<YamlEntry>& entries, std::string_view key);

// One document of one file. All refusals are InputErrors with file, place and key.
class YamlFile {
 public:
  // Throws InputError for text that is invalid YAML, not exactly one document, or beyond the bounds
  // of its size, depth and aliases (yaml_bounds.hpp).
  YamlFile(const std::string& text, std::string name);

  // The entries of the document itself.
  std::vector<YamlEntry> top() const;

  // The entries of a value that is a mapping, in the file's order; `path` and `known` are for
  // messages. Refuses what is no mapping, a key given twice, and a key that is no plain word.
  std::vector<YamlEntry> entries(const YamlEntry& entry, std::string_view path,
                                 const std::vector<std::string>& known) const;

  // The text of a plain value. Refuses lists, mappings and nothing at all; with `is_number` also
  // numbers in quotes.
  std::string scalar(const YamlEntry& entry, std::string_view path, const std::string& expected,
                     bool is_number) const;

  // Where files that it names are looked for.
  std::filesystem::path folder() const { return std::filesystem::path(name_).parent_path(); }

  [[noreturn]] void refuse(const YamlLocation& location, std::string_view key,
                           const std::string& message) const;

 private:
  std::vector<YAML::Node> documents_in(const std::string& text) const;

  std::string name_;
  YAML::Node document_;
};

}  // namespace autoref::runner
