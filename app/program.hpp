// The program, as a function: its only header that is quick to compile.
#pragma once

namespace autoref::app {

// Parses the command line and runs the chosen verb. Returns the exit code.
int run_command_line(int argc, const char* const* argv);

}  // namespace autoref::app
