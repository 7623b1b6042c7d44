#include "io/regular_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

#include "io/errors.hpp"

namespace autoref::io {
namespace {

constexpr mode_t kNewFileMode = 0666;

std::string_view kind_of_file(mode_t mode) {
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISLNK(mode)) return "a symbolic link";
  return "a device";
}

InputOutputError not_a_file(const std::filesystem::path& path, mode_t mode) {
  return InputOutputError(fmt::format("{} is {} where a file is expected; remove it", path.string(),
                                      kind_of_file(mode)));
}

// Before a device is opened, since that alone may have effects.
void refuse_other_kinds(const std::filesystem::path& path, int flags) {
  struct stat named {};
  const bool is_followed = (flags & O_NOFOLLOW) == 0;
  const int result = is_followed ? stat(path.c_str(), &named) : lstat(path.c_str(), &named);
  if (result != 0 || S_ISREG(named.st_mode)) return;
  throw not_a_file(path, named.st_mode);
}

}  // namespace

int open_regular_file(const std::filesystem::path& path, int flags) {
  refuse_other_kinds(path, flags);
  const int descriptor =
      open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, kNewFileMode);
  struct stat opened {};
  if (descriptor < 0 || (fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode)))
    return descriptor;
  // It has been replaced since the first look.
  close(descriptor);
  throw not_a_file(path, opened.st_mode);
}

}  // namespace autoref::io
