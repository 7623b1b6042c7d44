// Files that are installed with the program.
#pragma once

#include <filesystem>
#include <optional>

namespace autoref::io {

// The path of the running program; empty if the system does not report it.
std::filesystem::path running_program();

// PREFIX/share/autoref/NAME, if it exists, where `program` is PREFIX/bin/autoref. `name` is a path
// without "..".
std::optional<std::filesystem::path> installed_file(const std::filesystem::path& name,
                                                    const std::filesystem::path& program);

}  // namespace autoref::io
