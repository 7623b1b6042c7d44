#include "io/installed_files.hpp"

#include <algorithm>
#include <system_error>

namespace autoref::io {

namespace fs = std::filesystem;

fs::path running_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

std::optional<fs::path> installed_file(const fs::path& name, const fs::path& program) {
  const bool leads_up = std::find(name.begin(), name.end(), "..") != name.end();
  if (name.empty() || name.is_absolute() || leads_up) return std::nullopt;
  fs::path file = program.parent_path().parent_path() / "share" / "autoref" / name;
  std::error_code error;
  return fs::is_regular_file(file, error) ? std::optional(std::move(file)) : std::nullopt;
}

}  // namespace autoref::io
