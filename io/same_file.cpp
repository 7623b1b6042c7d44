#include "io/same_file.hpp"

#include <sys/stat.h>

namespace autoref::io {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // the limit of Linux

// Resolves links, "." and "..". The file need not exist; the last component may be a dangling link.
fs::path resolved(fs::path path) {
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    const fs::path target = fs::read_symlink(path, error);
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  path = fs::absolute(path, error);
  const fs::path whole = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : whole;
}

}  // namespace

bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  // equivalent() compares device and inode, so it also recognises hard links, but fails for files
  // that do not exist yet.
  return fs::equivalent(one, other, error) || resolved(one) == resolved(other);
}

bool is_open_as(const fs::path& path, int descriptor) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode) &&
         stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace autoref::io
