// The command line of `autoref`.
#pragma once

#include <functional>
#include <string_view>

namespace autoref::app {

// Runs the verb that the arguments name, and returns the program's exit code (io/errors.hpp).
int run_command_line(int argc, const char* const* argv);

// Runs `work`; turns an exception into a message on stderr, which begins with the program's name,
// and an exit code.
int exit_code_of(const std::function<int()>& work, std::string_view program = "autoref");

}  // namespace autoref::app
