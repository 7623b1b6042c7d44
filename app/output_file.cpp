#include "app/output_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& flag, const std::string& message) {
  throw io::InputError({flag}, "", message);
}

bool is_device(const std::string& path) {
  std::error_code none;
  return fs::is_character_file(path, none);
}

// Returns whether writing `output` would overwrite `other`. Output first goes to a temporary
// ".part" file, so that name must be free as well.
bool meets(const std::string& output, const std::string& other) {
  return io::is_same_file(output, other) || io::is_same_file(output + ".part", other);
}

void spare_inputs(const NamedFile& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (input.empty() || !meets(output.path, input)) continue;
    refuse(output.flag, fmt::format("this would overwrite {}", input));
  }
}

void spare_standard_streams(const NamedFile& output) {
  for (const auto& [descriptor, name] :
       {std::pair{STDOUT_FILENO, "output"}, {STDERR_FILENO, "error"}}) {
    if (!io::is_open_as(output.path, descriptor)) continue;
    refuse(output.flag, fmt::format("standard {} also goes to {}; use a separate file for each",
                                    name, output.path));
  }
}

}  // namespace

void check_outputs(const std::vector<NamedFile>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    if (output.path.empty() || is_device(output.path)) continue;
    spare_inputs(output, inputs);
    spare_standard_streams(output);
    for (std::size_t before = 0; before < i; ++before) {
      const NamedFile& other = outputs[before];
      if (other.path.empty()) continue;
      if (!meets(output.path, other.path) && !meets(other.path, output.path)) continue;
      refuse(fmt::format("{} and {}", other.flag, output.flag),
             fmt::format("both would write {}; use a separate file for each", output.path));
    }
  }
}

std::optional<io::PendingFile>& open_output(std::optional<io::PendingFile>& file, const char* flag,
                                            const std::string& path) {
  if (path.empty()) return file;
  try {
    return file.emplace(path, io::FileKind::kFileOrPipe), file;
  } catch (const io::InputOutputError& error) {
    throw io::InputError({flag}, "", error.what());
  }
}

LineOutput::LineOutput(const char* flag, const std::string& path) : path_(path) {
  open_output(file_, flag, path);
  struct stat status {};
  is_regular_ = file_ && fstat(file_->descriptor(), &status) == 0 && S_ISREG(status.st_mode);
}

void LineOutput::add(std::string_view line) {
  waiting_.append(line).append(1, '\n');
  if (!is_regular_ || waiting_.size() <= kMostWaiting_bytes) return;
  io::write_all(file_->descriptor(), waiting_, path_);
  waiting_.clear();
}

void LineOutput::commit() {
  if (file_) file_->commit(waiting_);
}

}  // namespace autoref::app
