// Standard error of a team's program: the beginning goes to a file, the end is kept.
#pragma once

#include <string>

namespace autoref::runner {

class ProgramStderr {
 public:
  // Takes over `descriptor`, which must not block. At most `most_bytes` go to `file` (empty: none).
  // Throws InputOutputError if the file cannot be created.
  ProgramStderr(int descriptor, const std::string& file, std::size_t most_bytes);
  ~ProgramStderr();
  ProgramStderr(const ProgramStderr&) = delete;
  ProgramStderr& operator=(const ProgramStderr&) = delete;

  int descriptor() const { return descriptor_; }  // readable when drain() is due; -1 at the end

  // Reads some of what has arrived. Returns whether there may be more. Never blocks.
  bool drain();

  // The last lines, at most eight and 1000 characters, with control characters as '?'.
  std::string last_lines() const;

 private:
  void keep(const char* text, std::size_t size);

  int descriptor_ = -1;
  int file_ = -1;
  std::size_t room_ = 0;
  std::string tail_;
};

}  // namespace autoref::runner
