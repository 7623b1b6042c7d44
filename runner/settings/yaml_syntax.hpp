// What is wrong with text that is invalid YAML, in words that say what to do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/settings/yaml.hpp"

namespace autoref::runner {

struct SyntaxMistake {
  YamlLocation location;
  std::string message;
};

// From where and what the parser complains, which is often a line too late and in its own terms.
SyntaxMistake syntax_mistake(const std::string& text, const YamlLocation& location,
                             const std::string& complaint);

// Where the quotes of the documents' last value open that are never closed, which the parser takes
// to close at the end of the file. None where all is well.
std::optional<YamlLocation> open_quote(const std::string& text,
                                       const std::vector<YAML::Node>& documents);

}  // namespace autoref::runner
