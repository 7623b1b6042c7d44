// Explains YAML syntax errors in terms of a remedy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/settings/yaml.hpp"

namespace autoref::game {

struct SyntaxMistake {
  YamlLocation location;
  std::string message;
};

// Explains a parser error, given its location and text; the parser often reports it a line too late
// and in its own terms.
SyntaxMistake syntax_mistake(const std::string& text, const YamlLocation& location,
                             const std::string& complaint);

// Location of quotes in the documents' last value that are never closed (the parser assumes that
// they close at the end of the file). Returns nullopt if there are none.
std::optional<YamlLocation> open_quote(const std::string& text,
                                       const std::vector<YAML::Node>& documents);

}  // namespace autoref::game
