// Reads whole files, writes files that appear complete or not at all, opens and compares files
// safely, and provides temporary folders and files installed with the program.
#pragma once

#include <stdlib.h>
#include <sys/types.h>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "io/errors.hpp"

namespace autoref::io {

// A temporary folder to work in, which is deleted when this object is destroyed.
class WorkingFolder {
 public:
  // Throws InputOutputError.
  WorkingFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "autoref-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw io_error(name + " cannot be created", errno);
    path_ = name;
  }
  ~WorkingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

// Opens a file even though another program may have put something else under its name. Works like
// open(2) with O_CLOEXEC, but never waits for another program and never touches a terminal or a
// device. `flags` are those of open(2); the umask determines who may read and write new files.
// Returns the descriptor, or -1 with errno if the file cannot be opened. Throws InputOutputError if
// the name leads to a FIFO, a device, a socket or a folder, or with O_NOFOLLOW to a symbolic link.
int open_regular_file(const std::filesystem::path& path, int flags);

// Returns whether both paths lead to the same file, regardless of links and spellings, and even if
// the file does not exist yet.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// Returns whether `descriptor` refers to this file; always false for terminals and pipes.
bool is_open_as(const std::filesystem::path& path, int descriptor);

// The path of the running program; empty if the system does not report it.
std::filesystem::path running_program();

// The installed file PREFIX/share/autoref/NAME, if it exists, where `program` is
// PREFIX/bin/autoref. `name` is a path without "..".
std::optional<std::filesystem::path> installed_file(const std::filesystem::path& name,
                                                    const std::filesystem::path& program);

// Returns the content of a file named by the user, which may be a pipe. Throws InputError if it
// cannot be read.
std::string read_user_file(const std::filesystem::path& path);

// Returns the content of one of AutoRef's own files, or nullopt if it does not exist. Throws
// InputOutputError on other failures, for example if another program has replaced the file with a
// FIFO.
std::optional<std::string> read_file(const std::filesystem::path& path);

// Receives a part of a file's content.
using TakePiece = std::function<void(std::string_view piece)>;

// Like read_file(), but passes the content on in pieces. Returns false if the file does not exist.
bool read_pieces(const std::filesystem::path& path, const TakePiece& take);

// Writes all of `text` to a descriptor. Throws InputOutputError naming `path`.
void write_all(int descriptor, std::string_view text, const std::filesystem::path& path);

// Like write(2) to a pipe. If its reader is gone, returns -1 with EPIPE but raises no signal.
ssize_t write_without_signal(int descriptor, std::string_view bytes);

// What a file name may refer to.
enum class FileKind {
  kFile,        // a file in one of AutoRef's folders
  kFileOrPipe,  // named by the user: can also be a pipe or a device such as /dev/stdout
  // Like kFileOrPipe, but a file's content appears as it is written, and stays if the process is
  // killed.
  kGrowing,
};

// New content for a file, which appears under its final name only at commit(), or as it is written
// (FileKind::kGrowing). If the user names something else (a pipe or /dev/stdout, for example), the
// content is written to it directly. A process killed before commit() leaves `path`.part behind,
// which the next process overwrites.
class PendingFile {
 public:
  // A growing file replaces the content of the file to which links lead; other files replace a
  // link. Throws InputOutputError if the file cannot be created, or if another process is still
  // writing to it after `patience_s`.
  explicit PendingFile(std::filesystem::path path, FileKind kind = FileKind::kFile,
                       double patience_s = 2);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  // False for a pipe or a device.
  bool is_file() const { return is_file_; }

  // The file's path; of a growing file, without links.
  const std::filesystem::path& path() const { return path_; }

  // The descriptor to write to, for content that is written in parts. Valid until commit().
  int descriptor() const { return descriptor_; }

  // Truncates a growing file; call this before writing to its descriptor. A file for which begin()
  // is never called stays as it was. Further calls do nothing, as for other files.
  void begin();

  // Begins and writes a part of the content.
  void write(std::string_view text);

  void commit(std::string_view text = {});

 private:
  bool is_direct() const { return part_ == path_; }
  bool grows_elsewhere() const;
  void wait_for_part(double patience_s);
  bool take_part();  // returns false if another process holds the file

  FileKind kind_;
  std::filesystem::path path_;
  std::filesystem::path part_;  // temporary file, renamed at commit(); `path` if there is none
  bool was_missing_ = false;    // whether there was nothing at `path`
  bool is_file_ = true;
  bool has_begun_ = false;
  int descriptor_ = -1;
};

// Replaces a file's content. Does not touch the file if it already has this content.
void replace_file(const std::filesystem::path& path, std::string_view text);

// Creates a folder and its parents. Throws InputOutputError.
void create_folder(const std::filesystem::path& path);

}  // namespace autoref::io
