#include "game/settings/yaml.hpp"

#include <fmt/format.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/errors.hpp"
#include "io/words.hpp"
#include "io/yaml_text.hpp"

namespace autoref::game {
namespace {

// A YAML syntax error and its remedy.
struct SyntaxMistake {
  YamlLocation location;
  std::string message;
};

// Finds the first line up to `last_line` that is indented by a tab.
std::optional<YamlLocation> tab_before(const std::string& text, int last_line) {
  std::size_t start = 0;
  for (int line = 1; line <= last_line && start < text.size(); ++line) {
    const std::size_t first = text.find_first_not_of(' ', start);
    if (first != std::string::npos && text[first] == '\t') {
      return YamlLocation{line, static_cast<int>(first - start) + 1};
    }
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) break;
    start = end + 1;
  }
  return std::nullopt;
}

// Common complaints of the parser, each with a remedy.
std::string remedy_of(const std::string& complaint) {
  static const std::map<std::string, std::string> kRemedies = {
      {YAML::ErrorMsg::MAP_VALUE, "put text that contains ': ' in quotes"},
      {YAML::ErrorMsg::FLOW_END, "a bracket before it is not closed, or does not match"},
      {YAML::ErrorMsg::END_OF_MAP_FLOW,
       "a '{' before here is not closed by '}', or a ':' has no space after it"},
      {YAML::ErrorMsg::END_OF_SEQ_FLOW, "a '[' before here is not closed by ']'"},
      {YAML::ErrorMsg::END_OF_MAP, "indent this line like the lines it belongs to"},
      {YAML::ErrorMsg::END_OF_SEQ, "indent this line like the lines it belongs to"}};
  const auto found = kRemedies.find(complaint);
  return found == kRemedies.end() ? "" : "; " + found->second;
}

YAML::Node last_value_in(YAML::Node node) {
  while ((node.IsMap() || node.IsSequence()) && node.size() > 0) {
    YAML::Node last;
    for (const auto& item : node) last.reset(node.IsMap() ? item.second : item);
    node.reset(last);
  }
  return node;
}

// Explains a parser error, given its location and text. The parser often reports errors a line too
// late and in its own terms.
SyntaxMistake syntax_mistake(const std::string& text, const YamlLocation& location,
                             const std::string& complaint) {
  if (const std::optional<YamlLocation> tab = tab_before(text, location.line)) {
    return {*tab, "this line is indented with a tab; use spaces"};
  }
  return {location, complaint + remedy_of(complaint)};
}

// Location of quotes in the documents' last value that are never closed (the parser assumes that
// they close at the end of the file). Returns nullopt if there are none.
std::optional<YamlLocation> open_quote(const std::string& text,
                                       const std::vector<YAML::Node>& documents) {
  if (documents.empty()) return std::nullopt;
  const YAML::Node last = last_value_in(documents.back());
  // The parser reads an unclosed quotation to the end of the file without complaint, so it can only
  // be the last value; the tag "!" marks a quoted scalar.
  if (!last.IsScalar() || last.Tag() != "!") return std::nullopt;
  const auto start = static_cast<std::size_t>(last.Mark().pos);
  if (start >= text.size() || text.find(text[start], start + 1) != std::string::npos) {
    return std::nullopt;
  }
  return location_of(last);
}

YamlLocation location_of(const YAML::Mark& mark) {
  if (mark.is_null()) return {};
  return {mark.line + 1, mark.column + 1};
}

constexpr std::size_t kLongestKey = 200;  // much longer than any setting's path

// Makes a quotation from a file safe for messages: short, and without control characters.
std::string for_message(std::string text) {
  constexpr std::size_t kMostQuoted = 60;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  if (text.size() > kMostQuoted) text.replace(kMostQuoted, std::string::npos, "...");
  return text;
}

std::string found(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Map:
      return "a mapping";
    case YAML::NodeType::Sequence:
      return "a list";
    case YAML::NodeType::Scalar:
      return fmt::format("'{}'", for_message(node.Scalar()));
    default:
      return "nothing";
  }
}

}  // namespace

YamlLocation location_of(const YAML::Node& node) { return location_of(node.Mark()); }

YamlLocation value_location(const YamlEntry& entry) {
  return entry.value.IsNull() ? entry.location : location_of(entry.value);
}

const YamlEntry* find_entry(const std::vector<YamlEntry>& entries, std::string_view key) {
  for (const YamlEntry& entry : entries) {
    if (entry.key == key) return &entry;
  }
  return nullptr;
}

YamlFile::YamlFile(const std::string& text, std::string name) : name_(std::move(name)) {
  const std::vector<YAML::Node> documents = documents_in(text);
  if (const std::optional<YamlLocation> quote = open_quote(text, documents)) {
    refuse(*quote, "", "invalid YAML: the quotes opened here are never closed");
  }
  if (documents.empty()) refuse({}, "", "the file is empty; expected a scenario");
  if (documents.size() > 1) {
    refuse(game::location_of(documents[1]), "",
           "expected one document, found a second one; leave out the line ---");
  }
  document_ = documents[0];
}

// Check the bounds of every document before reading it.
std::vector<YAML::Node> YamlFile::documents_in(const std::string& text) const {
  try {
    if (const std::optional<io::BeyondBounds> beyond = io::beyond_bounds(text)) {
      refuse({beyond->line, beyond->column}, "", beyond->message);
    }
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& error) {
    const SyntaxMistake mistake = syntax_mistake(text, location_of(error.mark), error.msg);
    refuse(mistake.location, "", "invalid YAML: " + mistake.message);
  }
}

std::vector<YamlEntry> YamlFile::top() const { return entries({"", {1, 1}, document_}, "", {}); }

std::vector<YamlEntry> YamlFile::entries(const YamlEntry& entry, std::string_view path,
                                         const std::vector<std::string>& known) const {
  if (!entry.value.IsMap()) {
    const std::string keys = known.empty() ? "key: value" : io::listed(known);
    refuse(value_location(entry), path,
           fmt::format("expected a mapping ({}), found {}", keys, found(entry.value)));
  }
  std::vector<YamlEntry> entries;
  std::map<std::string, int> lines;  // lines of the keys so far
  for (const auto& pair : entry.value) {
    const YamlLocation location = game::location_of(pair.first);
    if (!pair.first.IsScalar()) refuse(location, path, "expected a word as key");
    const std::string key = pair.first.Scalar();
    if (key.size() > kLongestKey)
      refuse(location, path, fmt::format("expected a word as key, found '{}'", for_message(key)));
    const auto [first, is_new] = lines.try_emplace(key, location.line);
    if (!is_new) {
      refuse(location, path,
             fmt::format("the key '{}' is given twice, first in line {}; leave one out",
                         for_message(key), first->second));
    }
    entries.push_back({key, location, pair.second});
  }
  return entries;
}

std::string YamlFile::scalar(const YamlEntry& entry, std::string_view path,
                             const std::string& expected, bool is_number) const {
  const bool is_quoted = entry.value.Tag() == "!";
  if (!entry.value.IsScalar() || (is_number && is_quoted)) {
    refuse(value_location(entry), path,
           fmt::format("expected {}, found {}{}", expected, found(entry.value),
                       is_quoted ? " in quotes" : ""));
  }
  return entry.value.Scalar();
}

std::vector<std::string> YamlFile::words(const YamlEntry& entry, std::string_view path) const {
  std::vector<std::string> words;
  words.reserve(entry.value.size());
  for (const YAML::Node& word : entry.value) {
    if (!word.IsScalar())
      refuse(location_of(word), path, fmt::format("expected a word, found {}", found(word)));
    words.push_back(word.Scalar());
  }
  return words;
}

void YamlFile::refuse(const YamlLocation& location, std::string_view key,
                      const std::string& message) const {
  throw io::InputError({name_, location.line, location.column}, key, message);
}

}  // namespace autoref::game
