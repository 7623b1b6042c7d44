// A temporary folder to work in.
#pragma once

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "io/errors.hpp"

namespace autoref::io {

// Deleted with this object.
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

}  // namespace autoref::io
