// The command line of `autoref`.
#pragma once

#include <functional>
#include <string_view>

namespace autoref::app {

// Runs the verb named by the arguments and returns the program's exit code (io/errors.hpp).
int run_command_line(int argc, const char* const* argv);

// Runs `work`; on an exception, prints a message that begins with the program's name on stderr and
// returns the matching exit code.
int exit_code_of(const std::function<int()>& work, std::string_view program = "autoref");

}  // namespace autoref::app
