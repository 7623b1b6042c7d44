// Error messages for command lines that cannot be parsed.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace autoref::app {

// Returns whether the program, or a verb that itself has verbs, has a verb of this name.
bool is_verb(const CLI::App& app, const std::string& word);

// "unknown verb 'plya'; did you mean 'play'? `autoref help` lists them". `app` can be a verb, with
// or without verbs below it.
std::string unknown_verb_message(const CLI::App& app, const std::string& word);

// Returns a message about an error thrown by parse(). The message names the verb, such as "team
// new", says what is wrong with its arguments (in the order given), and suggests the option or word
// that was probably meant.
std::string message_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace autoref::app
