#include "app/experiment/ci_files.hpp"

#include <fmt/format.h>

#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::app {

namespace fs = std::filesystem;

void prepare_ci_folder(const fs::path& folder) {
  try {
    io::create_folder(folder);
    for (const char* name : {kCiMarkdown, kCiJunit}) {
      const fs::path file = folder / name;
      if (fs::is_directory(file))
        throw io::InputOutputError(fmt::format("{} is a folder", file.string()));
      const io::PendingFile probe(file);  // without commit(), leaves nothing behind
      fs::remove(file);
    }
  } catch (const io::InputOutputError& error) {
    throw io::InputError({"--ci"}, "", fmt::format("{}; choose another folder", error.what()));
  } catch (const fs::filesystem_error& error) {
    throw io::InputError({"--ci"}, "", fmt::format("{}; choose another folder", error.what()));
  }
}

void write_ci_files(const CiReport& report, const fs::path& folder) {
  io::replace_file(folder / kCiMarkdown, comparison_markdown(report));
  io::replace_file(folder / kCiJunit, comparison_junit(report));
}

}  // namespace autoref::app
