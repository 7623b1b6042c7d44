// The user that runs a team's program if AutoRef runs as root.
#pragma once

#include <string>
#include <vector>

#include "io/working_folder.hpp"

namespace autoref::game {

// Whether this process has the rights of root, here or outside its user namespace. If so, a program
// must not run under its user.
bool runs_as_root();

// A user id without an account, different from those of all programs that run at once, and a folder
// that belongs to it. Both last as long as this object.
class ProgramUser {
 public:
  // Throws InputOutputError if every id is in use, or the lock or the folder cannot be had.
  ProgramUser();

  int id() const { return id_; }  // also of its group

  // Makes the user the owner of an open file.
  void give(int descriptor) const;

  // "NAME=value": the folder as HOME and TMPDIR.
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
