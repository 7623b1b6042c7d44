// Error messages for command lines that cannot be parsed.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace autoref::runner {

// Returns whether the program has a verb of this name.
bool is_verb(const CLI::App& app, const std::string& word);

// "there is no verb 'plya'; did you mean 'play'? `autoref help` lists them". For a renamed verb,
// the message gives its new name.
std::string unknown_verb_message(const CLI::App& app, const std::string& word);

// Explains an error thrown by parse(): the verb, what is wrong with its arguments (in the order
// given), and the most likely intended option.
std::string message_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace autoref::runner
