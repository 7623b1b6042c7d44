// A temporary folder of a benchmark.
#pragma once

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "runner/io/errors.hpp"

namespace autoref::runner {

// Deleted with this object.
class BenchFolder {
 public:
  // Throws InputOutputError.
  BenchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "autoref-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw io_error(name + " cannot be created", errno);
    path_ = name;
  }
  ~BenchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  BenchFolder(const BenchFolder&) = delete;
  BenchFolder& operator=(const BenchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace autoref::runner
