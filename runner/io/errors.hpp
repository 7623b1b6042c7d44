// What can go wrong outside a game, and the exit codes that scripts can trust.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::runner {

enum ExitCode : int {
  kDone = 0,
  kBadInput = 2,      // a file, a key or a flag is wrong; the message says which
  kTooManyVoid = 3,   // more than one game in twenty went wrong
  kDifferent = 4,     // a game that was played again did not come out as before
  kInternal = 70,     // internal error
  kInputOutput = 74,  // a folder or file cannot be written, or another run holds the folder
  kInterrupted = 75,  // the same command continues
};

// Share of void games above which an experiment says kTooManyVoid.
inline constexpr double kMostVoid = 0.05;

// A place in a user's file. Lines and columns count from 1; 0 where there is none.
struct FileLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

// A user's mistake: exit code 2. what() reads "file:line:column: key: message".
class InputError : public std::runtime_error {
 public:
  InputError(const FileLocation& location, std::string_view key, std::string_view message);

  const FileLocation& location() const { return location_; }
  const std::string& key() const { return key_; }

 private:
  FileLocation location_;
  std::string key_;
};

// The machine's fault: exit code 74.
class InputOutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// "cannot write results.csv: No space left on device": `what` with the reason from `errno`.
InputOutputError io_error(std::string_view what, int error_number);

// Says something to people on `stream`, usually stderr. Where nobody can hear it any more, because
// the terminal is gone or the disk is full, nothing happens: results and exit code still count.
void write_message(std::FILE* stream, std::string_view text);

// The user pressed Ctrl-C: exit code 75.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace autoref::runner
