// YAML with locations: a thin, strict layer over yaml-cpp.
#pragma once

#include <yaml-cpp/yaml.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::game {

// Line and column in a file, counted from 1; 0 if unknown.
struct YamlLocation {
  int line = 0;
  int column = 0;
};

struct YamlEntry {
  std::string key;
  YamlLocation location;  // location of the key
  YAML::Node value;
};

YamlLocation location_of(const YAML::Node& node);

// The location of the value, or of the key if there is no value.
YamlLocation value_location(const YamlEntry& entry);

// The entry with that key, or nullptr.
const YamlEntry* find_entry(const std::vector<YamlEntry>& entries, std::string_view key);

// One document of one file. All errors are InputErrors with file, location and key.
class YamlFile {
 public:
  // Throws InputError for invalid YAML, for anything but exactly one document, and for text that
  // exceeds the limits on size, depth and aliases (yaml_text.hpp).
  YamlFile(const std::string& text, std::string name);

  // The entries of the document itself.
  std::vector<YamlEntry> top() const;

  // The entries of a mapping, in the file's order; `path` and `known` are for messages. Throws
  // InputError if the value is not a mapping, a key is given twice, or a key is not a plain word.
  std::vector<YamlEntry> entries(const YamlEntry& entry, std::string_view path,
                                 const std::vector<std::string>& known) const;

  // The text of a plain value. Throws InputError for lists, mappings and missing values, and with
  // `is_number` also for numbers in quotes.
  std::string scalar(const YamlEntry& entry, std::string_view path, const std::string& expected,
                     bool is_number) const;

  // The plain values of a list. Throws InputError for anything else.
  std::vector<std::string> words(const YamlEntry& entry, std::string_view path) const;

  // The folder to which relative paths in the file refer.
  std::filesystem::path folder() const { return std::filesystem::path(name_).parent_path(); }

  [[noreturn]] void refuse(const YamlLocation& location, std::string_view key,
                           const std::string& message) const;

 private:
  std::vector<YAML::Node> documents_in(const std::string& text) const;

  std::string name_;
  YAML::Node document_;
};

}  // namespace autoref::game
