// The process between AutoRef and a team's program. It starts the program, counts its processes,
// and ends all of them when the program or AutoRef ends. Used by program_process.cpp.
#pragma once

#include <sys/types.h>

#include "game/team_programs/program_spec.hpp"

namespace autoref::game {

// A report of the supervisor, sent in one write.
struct SupervisorReport {
  enum Kind : int {
    kEnded,
    kTooManyProcesses,
    kNoUser,  // from here on, the kinds of failure to start the program
    kNoDirectory,
    kUnreadable,
    kNoProgram,
    kNoProcess
  };
  Kind kind = kEnded;
  int value = 0;      // kEnded: status as from waitpid(); failures to start: the error number
  int argument = -1;  // kUnreadable: index of the word of the command that names the file
};

// Descriptors for the supervisor and the program. All are close-on-exec.
struct ProgramEnds {
  int in = -1;  // the program's standard input, output and error
  int out = -1;
  int err = -1;
  int life = -1;     // a byte requests SIGTERM; end of file ends everything
  int reports = -1;  // receives SupervisorReports
  // Receives a SupervisorReport if the program cannot start; otherwise it is closed.
  int started = -1;
};

struct Supervisor {
  pid_t pid = -1;
  // Whether the kernel ends all processes of the program when the supervisor ends.
  bool has_namespace = false;
};

// Value of `user` for a program that runs under the user of this process.
inline constexpr int kSameUser = -1;

// Starts a supervisor, in a PID namespace if the system allows one. `user` is the id under which
// the program runs without further rights (only root can choose one); the supervisor keeps its own
// user. Throws InputOutputError.
Supervisor start_supervisor(const ProgramSpec& spec, const ProgramEnds& ends, int user);

}  // namespace autoref::game
