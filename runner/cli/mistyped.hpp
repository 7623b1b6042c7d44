// What is said of a command line that cannot be read.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace autoref::runner {

// Whether the program has that verb.
bool is_verb(const CLI::App& app, const std::string& word);

// "there is no verb 'plya'; did you mean 'play'? `autoref help` lists them"; a verb that was
// renamed is named as it is called today.
std::string unknown_verb_message(const CLI::App& app, const std::string& word);

// Explains an error that parse() threw: the verb, what is wrong with its arguments, in the order
// given, and the option that was probably meant.
std::string message_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace autoref::runner
