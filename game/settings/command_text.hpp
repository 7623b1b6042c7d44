// Commands as one line of text: words separated by spaces.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::game {

// The words of a command. A word with spaces is put in single or double quotes; except in single
// quotes, the character after a backslash is taken literally. There are no variables or patterns,
// since no shell is involved. Throws std::invalid_argument if a quote is not closed.
std::vector<std::string> words_of_command(std::string_view text);

// The command in a canonical form that words_of_command() reads back.
std::string text_of_command(const std::vector<std::string>& words);

}  // namespace autoref::game
