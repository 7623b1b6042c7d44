#include "game/settings/yaml_syntax.hpp"

#include <fmt/format.h>

#include <map>

namespace autoref::game {
namespace {

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

}  // namespace

SyntaxMistake syntax_mistake(const std::string& text, const YamlLocation& location,
                             const std::string& complaint) {
  if (const std::optional<YamlLocation> tab = tab_before(text, location.line)) {
    return {*tab, "this line is indented with a tab; use spaces"};
  }
  return {location, complaint + remedy_of(complaint)};
}

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

}  // namespace autoref::game
