#include "runner/cli/output_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "runner/io/errors.hpp"

namespace autoref::runner {

void spare_source(const char* flag, const std::string& path, const std::string& source) {
  std::error_code none;
  if (!std::filesystem::equivalent(path, source, none)) return;
  throw InputError({flag}, "", fmt::format("this is {} itself, which would be lost", source));
}

std::optional<PendingFile>& open_output(std::optional<PendingFile>& file, const char* flag,
                                        const std::string& path) {
  if (path.empty()) return file;
  try {
    return file.emplace(path), file;
  } catch (const InputOutputError& error) {
    throw InputError({flag}, "", error.what());
  }
}

}  // namespace autoref::runner
