#include "runner/cli/scenario_argument.hpp"

#include <fmt/format.h>

#include <system_error>

#include "runner/io/errors.hpp"
#include "runner/io/installed_files.hpp"

namespace autoref::runner {

std::string found_scenario(const std::string& file, const std::filesystem::path& program) {
  std::error_code error;
  if (std::filesystem::exists(file, error)) return file;
  const auto installed = installed_file(file, program);
  return installed ? installed->string() : file;
}

CLI::Option* add_scenario_argument(CLI::App& verb, std::string& file, const std::string& about) {
  const auto find = [&file](const std::string& given) {
    file = found_scenario(given, running_program());
    if (file != given) write_message(stderr, fmt::format("autoref: reading {}\n", file));
  };
  return verb.add_option_function<std::string>("FILE", find, about)->required();
}

}  // namespace autoref::runner
