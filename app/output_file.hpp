// Output files named by command-line flags.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files.hpp"

namespace autoref::app {

// A file that a verb reads or writes.
struct NamedFile {
  std::string flag;  // the flag that names it, such as "--log"
  std::string path;
};

// Throws InputError naming both flags if two outputs are the same file, even if their paths are
// written differently. Also throws it if an output is one of `inputs` or the file to which a
// standard stream is redirected. In all these cases, one of the two files would be lost. Call this
// function before doing any work. Several outputs may share a terminal or /dev/null.
void check_outputs(const std::vector<NamedFile>& outputs, const std::vector<std::string>& inputs);

// Opens the file before any work is done, so that a wrong name is reported immediately. Leaves
// `file` empty if the path is empty. Throws InputError naming `flag`.
std::optional<io::PendingFile>& open_output(std::optional<io::PendingFile>& file, const char* flag,
                                            const std::string& path,
                                            io::FileKind kind = io::FileKind::kFileOrPipe);

// When the lines of an output file appear under its name.
enum class Appears {
  kAtEnd,   // all at once at commit()
  kAtOnce,  // each as it is added, so that none is lost if the program is killed
};

// An output file that grows line by line. If the lines appear at the end, they are written to disk
// in batches, so a long game needs no more memory than a short one. A reader must not delay the
// game: if the file is, for example, a pipe, lines that appear at the end are all written at
// commit(), and lines that appear at once wait while the pipe is full. If lines that appear at once
// cannot be written, the game goes on without them: this is said once on stderr.
class LineOutput {
 public:
  static constexpr std::size_t kMostWaiting_bytes = 64 * 1024;  // kept for a regular file

  // Opens no file if the path is empty. Throws InputError naming `flag`.
  LineOutput(const char* flag, const std::string& path, Appears appears = Appears::kAtEnd);

  bool is_open() const { return file_.has_value(); }

  // Truncates a file whose lines appear at once, and writes the lines added before. Does nothing
  // for other files.
  void begin();

  // Adds a line, given without its line break. Does nothing if no file is open. Throws
  // InputOutputError if lines that appear at the end cannot be written.
  void add(std::string_view line);

  // Does nothing if no file is open. Throws InputOutputError, also if lines could not be written
  // before.
  void commit();

  // Size of the lines not written yet.
  std::size_t waiting_bytes() const { return waiting_.size(); }

 private:
  void write_waiting();
  void write_at_once();
  void write_what_fits();

  std::string path_;
  Appears appears_;
  std::optional<io::PendingFile> file_;
  bool has_begun_ = false;
  std::string waiting_;
  std::string failure_;  // empty: none
};

}  // namespace autoref::app
