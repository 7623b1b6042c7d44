// Options whose value is one of a few words.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace autoref::app {

// A check that accepts only these words; its message suggests one for another word. Help lists
// them, and so does completion (described_verb.hpp).
CLI::Validator one_of(const std::vector<std::string>& words);

// The words of a check in an option's type name, such as "STYLE:{plain,json,none}", or of a type
// name such as "west|east"; words in capitals, such as FACTOR of "FACTOR|max", do not count.
std::vector<std::string> words_in_type(const std::string& type_name);

}  // namespace autoref::app
