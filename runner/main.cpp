// The command line `autoref`.
#include "runner/verbs/command_line.hpp"

int main(int argc, char** argv) { return autoref::runner::run_command_line(argc, argv); }
