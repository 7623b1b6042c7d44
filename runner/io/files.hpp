// Files that are read whole, and files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace autoref::runner {

// The content of a file that the user named. Throws InputError where it cannot be read.
std::string read_user_file(const std::filesystem::path& path);

// The content; none where there is no such file. Throws InputOutputError for other troubles.
std::optional<std::string> read_file(const std::filesystem::path& path);

// Writes all of `text` to a descriptor; throws InputOutputError that names `path`.
void write_all(int descriptor, std::string_view text, const std::filesystem::path& path);

// A new content for a file, which appears under its name by commit() and not before. What is no
// regular file (a pipe, /dev/stdout) is written to directly at commit(). A process that is killed
// before leaves `path`.part, which the next one writes over.
class PendingFile {
 public:
  // Throws InputOutputError where the file cannot be created, or where another process keeps
  // writing it for longer than `patience_s`.
  explicit PendingFile(std::filesystem::path path, double patience_s = 2);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  void commit(std::string_view text);

 private:
  bool is_direct() const { return part_ == path_; }
  void wait_for_part(double patience_s);
  bool take_part();  // false where another process has it

  std::filesystem::path path_;
  std::filesystem::path part_;  // written first, then renamed
  int descriptor_ = -1;
};

// Replaces a file's content; a file that has this content already is left alone.
void replace_file(const std::filesystem::path& path, std::string_view text);

// Creates a folder and those above it. Throws InputOutputError.
void create_folder(const std::filesystem::path& path);

}  // namespace autoref::runner
