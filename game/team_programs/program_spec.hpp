// How to start a team that is a program of its own, and what it may use.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace autoref::game {

struct ProgramLimits {
  std::uint64_t memory_bytes = 4ULL << 30;  // written to by each process
  std::uint64_t open_files = 256;           // of each process
  int processes = 64;                       // at once, threads not counted; more end the program
  std::uint64_t tasks = 512;            // processes and threads at once; the kernel refuses more
  std::uint64_t cpu_s = 3600;           // of each process
  double answer_s = 10.0;               // wall clock; only to detect programs that hang
  std::size_t stderr_bytes = 1U << 20;  // in the file of standard error; the rest is dropped
};

struct ProgramSpec {
  std::vector<std::string> command;      // the program, sought in PATH, and its arguments; no shell
  std::string directory = {};            // working directory; empty: AutoRef's
  std::vector<std::string> environment;  // "NAME=value", in addition to AutoRef's environment
  std::string stderr_file = {};          // empty: only the last lines are kept
  int stderr_copy = -1;                  // descriptor that also takes standard error; -1: none
  ProgramLimits limits = {};
};

// A fault of the program. what() says what it did, followed by its last lines on standard error.
class ProgramError : public std::runtime_error {
 public:
  explicit ProgramError(const std::string& what, bool is_from_outside = false)
      : std::runtime_error(what), was_killed_from_outside(is_from_outside) {}

  bool was_killed_from_outside;  // so that it is not to blame
};

}  // namespace autoref::game
