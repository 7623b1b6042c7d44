// Parses the words used in cases.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "referee/decision.hpp"
#include "tests/referee/rules/yaml_keys.hpp"

namespace autoref::referee {

// All functions parse the text of `key`, or `word` if given. They throw CaseError if the text is
// unknown.
template <typename T>
T word_in(YamlKeys& keys, const std::string& key, const std::string& word,
          const std::vector<std::pair<std::string, T>>& words) {
  std::string known;
  for (const auto& [name, value] : words) {
    if (name == word) return value;
    known += (known.empty() ? "" : ", ") + name;
  }
  keys.refuse(key, "'" + word + "' is not one of " + known);
}

Event event_of(YamlKeys& keys, const std::string& key, const std::string& word);
std::vector<Event> events_of(YamlKeys& keys, const std::string& key);
Side side_of(YamlKeys& keys, const std::string& key, const std::string& word);
Side side_of(YamlKeys& keys, const std::string& key);
// "west 3".
RobotId robot_of(YamlKeys& keys, const std::string& key, const std::string& words);
RobotId robot_of(YamlKeys& keys, const std::string& key);
// "direct_free west", "force_start".
Command command_of(YamlKeys& keys, const std::string& key);
Card card_of(YamlKeys& keys, const std::string& key);

}  // namespace autoref::referee
