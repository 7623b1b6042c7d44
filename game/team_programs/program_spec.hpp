// The program of a team and the user under which it runs.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/files.hpp"

namespace autoref::game {

struct ProgramLimits {
  std::uint64_t memory_bytes = 4ULL << 30;  // memory that each process may write to
  std::uint64_t open_files = 256;           // number of open files per process
  // At a time, not counting threads; the program is ended if it has more.
  int processes = 64;
  std::uint64_t tasks = 512;   // processes and threads at a time; the kernel refuses more
  std::uint64_t cpu_s = 3600;  // processor time of each process
  // Wall-clock limit for an answer; only to detect programs that hang.
  double answer_s = 10.0;
  std::size_t stderr_bytes = 1U << 20;  // size of the file of standard error; the rest is dropped
};

struct ProgramSpec {
  std::vector<std::string> command;      // the program, sought in PATH, and its arguments; no shell
  std::string directory = {};            // working directory; empty: AutoRef's
  std::vector<std::string> environment;  // "NAME=value", in addition to AutoRef's environment
  std::string stderr_file = {};          // empty: only the last lines are kept
  int stderr_copy = -1;                  // descriptor that also receives standard error; -1: none
  ProgramLimits limits = {};
};

// A fault of the program. what() describes the fault, followed by the program's last lines on
// standard error.
class ProgramError : public std::runtime_error {
 public:
  explicit ProgramError(const std::string& what, bool is_from_outside = false)
      : std::runtime_error(what), was_killed_from_outside(is_from_outside) {}

  bool was_killed_from_outside;  // in that case, the program is not to blame
};

// Whether this process has root rights, inside or outside its user namespace. If so, a program must
// not run under the same user.
bool runs_as_root();

// A user id without an account, different from the user ids of all other running programs, and a
// folder that belongs to this user. The user id and the folder last as long as this object.
class ProgramUser {
 public:
  // Throws InputOutputError if every id is in use, or if the lock or the folder cannot be obtained.
  ProgramUser();

  int id() const { return id_; }  // also the id of the user's group

  // Makes the user the owner of an open file.
  void give(int descriptor) const;

  // "NAME=value" entries that set HOME and TMPDIR to the folder.
  std::vector<std::string> environment() const;

 private:
  struct LockFile {
    LockFile();
    ~LockFile();
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;

    int descriptor;
  };

  int id_ = -1;
  LockFile locks_;
  io::WorkingFolder folder_;
};

}  // namespace autoref::game
