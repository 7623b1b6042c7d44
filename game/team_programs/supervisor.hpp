// The process between AutoRef and a team's program. It starts the program, counts the processes,
// and ends all of them when the program ends or AutoRef does. Used by program_process.cpp.
#pragma once

#include <sys/types.h>

#include "game/team_programs/program_spec.hpp"

namespace autoref::game {

// What the supervisor reports, in one write.
struct SupervisorReport {
  enum Kind : int {
    kEnded,
    kTooManyProcesses,
    kNoUser,  // failures to start, from here on
    kNoDirectory,
    kUnreadable,
    kNoProgram,
    kNoProcess
  };
  Kind kind = kEnded;
  int value = 0;      // kEnded: status as from waitpid(); failures to start: the error number
  int argument = -1;  // kUnreadable: the word of the command that names the file
};

// Descriptors for the supervisor and the program. All are close-on-exec.
struct ProgramEnds {
  int in = -1;  // the program's standard input, output and error
  int out = -1;
  int err = -1;
  int life = -1;     // a byte asks for SIGTERM; the end of the file ends everything
  int reports = -1;  // takes SupervisorReports
  int started = -1;  // takes a SupervisorReport if the program cannot start; closed if it does
};

struct Supervisor {
  pid_t pid = -1;
  bool has_namespace = false;  // the kernel ends all processes of the program with the supervisor
};

// The program runs under the user of this process.
inline constexpr int kSameUser = -1;

// Starts a supervisor, in a PID namespace if the system allows one. `user` is the id under which
// the program runs without further rights, which only root can choose; the supervisor itself
// keeps its user. Throws InputOutputError.
Supervisor start_supervisor(const ProgramSpec& spec, const ProgramEnds& ends, int user);

}  // namespace autoref::game
