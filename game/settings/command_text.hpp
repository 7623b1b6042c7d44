// Commands as one line of text: words separated by spaces.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::game {

// The words of a command. A word with spaces stands in single or double quotes; a backslash keeps
// the next character as it is, except in single quotes. There are no variables and no patterns:
// no shell is involved. Throws std::invalid_argument if a quote is not closed.
std::vector<std::string> words_of_command(std::string_view text);

// The command in a form that words_of_command() reads back, always spelt the same.
std::string text_of_command(const std::vector<std::string>& words);

}  // namespace autoref::game
