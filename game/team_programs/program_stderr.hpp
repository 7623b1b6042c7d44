// Standard error of a team's program: its beginning is written to a file, its end is kept in
// memory.
#pragma once

#include <string>

#include "game/team_programs/program_spec.hpp"

namespace autoref::game {

class ProgramStderr {
 public:
  // Takes over `descriptor`, which must not block. At most spec.limits.stderr_bytes are written; a
  // file is created only if there is anything to write. If writing fails, for example because the
  // disk is full or the program has put something else at the file's path, one message on stderr
  // says so, and the lines are dropped.
  ProgramStderr(int descriptor, const ProgramSpec& spec);
  ~ProgramStderr();
  ProgramStderr(const ProgramStderr&) = delete;
  ProgramStderr& operator=(const ProgramStderr&) = delete;

  int descriptor() const { return descriptor_; }  // readable when drain() is due; -1 at the end

  // Reads some of what has arrived. Returns whether there may be more. Never blocks.
  bool drain();

  // The last lines, at most four and 200 characters, with '?' in place of non-ASCII characters.
  std::string last_lines() const;

 private:
  void keep(const char* text, std::size_t size);
  void write_to_file(const char* text, std::size_t size);
  void give_up_file(int error_number);

  int descriptor_ = -1;
  std::string file_name_;
  int file_ = -1;
  int copy_ = -1;
  std::size_t room_ = 0;
  std::string tail_;
};

}  // namespace autoref::game
