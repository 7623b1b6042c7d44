// Errors that can occur outside a game, and the exit codes that scripts can rely on.
#pragma once

#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::io {

enum ExitCode : int {
  kDone = 0,
  kNotMet = 1,       // a comparison does not show what is required
  kBadInput = 2,     // a file, a key or a flag is invalid; the message says which
  kTooManyVoid = 3,  // more than one game in twenty failed
  kDifferent = 4,  // a replayed game differs from the original, or stored rows are damaged or lost
  kInternal = 70,  // internal error
  kInputOutput = 74,  // a failure of the environment, or another run uses the folder
  kInterrupted = 75,  // repeat the command to continue
};

// An experiment ends with kTooManyVoid if the proportion of void games exceeds this value.
inline constexpr double kMostVoid = 0.05;

// A position in a user's file. Lines and columns count from 1; 0 means unknown.
struct FileLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

// A user error: exit code 2. what() reads "file:line:column: key: message".
class InputError : public std::runtime_error {
 public:
  InputError(const FileLocation& location, std::string_view key, std::string_view message);

  const FileLocation& location() const { return location_; }
  const std::string& key() const { return key_; }

 private:
  FileLocation location_;
  std::string key_;
};

// A failure of the environment, such as a full disk: exit code 74.
class InputOutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// "cannot write results.csv: No space left on device": `what` and the reason for `error_number`.
InputOutputError io_error(std::string_view what, int error_number);

// Whether the error number means that the system is out of disk space, memory, processes or
// descriptors.
bool is_shortage(int error_number);

// The message if the exception is a failure of the environment: an InputOutputError, or an
// exception of the standard library or Boost about memory or the operating system. nullopt for
// other exceptions.
std::optional<std::string> environment_failure(const std::exception& error);

// Writes a message for the user to `stream`, usually stderr. Errors while writing are ignored (if
// the terminal is gone or the disk is full, for example): the program's results and exit code are
// still valid.
void write_message(std::FILE* stream, std::string_view text);

// The user pressed Ctrl-C: exit code 75.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace autoref::io
