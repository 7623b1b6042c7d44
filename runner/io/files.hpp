// Files that are read as a whole, and files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace autoref::runner {

// Returns the content of a file named by the user. Throws InputError if it cannot be read.
std::string read_user_file(const std::filesystem::path& path);

// Returns the content, or nullopt if the file does not exist. Throws InputOutputError on other
// failures.
std::optional<std::string> read_file(const std::filesystem::path& path);

// Writes all of `text` to a descriptor. Throws InputOutputError naming `path`.
void write_all(int descriptor, std::string_view text, const std::filesystem::path& path);

// New content for a file, which appears under its final name only at commit(). If the path is not a
// regular file (but a pipe or /dev/stdout, for example), commit() writes to it directly. A process
// killed before commit() leaves `path`.part behind, which the next process overwrites.
class PendingFile {
 public:
  // Throws InputOutputError if the file cannot be created, or if another process is still writing
  // it after `patience_s`.
  explicit PendingFile(std::filesystem::path path, double patience_s = 2);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  // For content that is not written at once. Valid until commit().
  int descriptor() const { return descriptor_; }

  void commit(std::string_view text = {});

 private:
  bool is_direct() const { return part_ == path_; }
  void wait_for_part(double patience_s);
  bool take_part();  // returns false if another process holds the temporary file

  std::filesystem::path path_;
  std::filesystem::path part_;  // temporary file, renamed at commit()
  int descriptor_ = -1;
};

// Replaces a file's content. Does not touch the file if it already has this content.
void replace_file(const std::filesystem::path& path, std::string_view text);

// Creates a folder and its parents. Throws InputOutputError.
void create_folder(const std::filesystem::path& path);

}  // namespace autoref::runner
