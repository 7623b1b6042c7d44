#include "app/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
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
                                            const std::string& path, io::FileKind kind) {
  if (path.empty()) return file;
  try {
    return file.emplace(path, kind), file;
  } catch (const io::InputOutputError& error) {
    throw io::InputError({flag}, "", error.what());
  }
}

LineOutput::LineOutput(const char* flag, const std::string& path, Appears appears)
    : path_(path), appears_(appears) {
  const bool is_growing = appears == Appears::kAtOnce;
  open_output(file_, flag, path, is_growing ? io::FileKind::kGrowing : io::FileKind::kFileOrPipe);
}

void LineOutput::begin() {
  if (!file_ || appears_ != Appears::kAtOnce || std::exchange(has_begun_, true)) return;
  write_at_once();
}

void LineOutput::add(std::string_view line) {
  if (!file_ || !failure_.empty()) return;
  waiting_.append(line).append(1, '\n');
  if (appears_ == Appears::kAtOnce) {
    if (has_begun_) write_at_once();
  } else if (file_->is_file() && waiting_.size() > kMostWaiting_bytes) {
    write_waiting();
  }
}

void LineOutput::write_waiting() {
  file_->write(waiting_);
  waiting_.clear();
}

void LineOutput::write_at_once() {
  try {
    file_->is_file() ? write_waiting() : write_what_fits();
  } catch (const io::InputOutputError& error) {
    failure_ = error.what();
    waiting_.clear();
    io::write_message(stderr, fmt::format("autoref: {}\n", failure_));
  }
}

// A terminal or a device may take everything; a pipe may be full.
void LineOutput::write_what_fits() {
  const int descriptor = file_->descriptor();
  const int flags = fcntl(descriptor, F_GETFL);
  fcntl(descriptor, F_SETFL, flags | O_NONBLOCK);
  const ssize_t count = io::write_without_signal(descriptor, waiting_);
  const int error_number = errno;
  fcntl(descriptor, F_SETFL, flags);
  if (count >= 0) {
    waiting_.erase(0, static_cast<std::size_t>(count));
  } else if (error_number != EAGAIN && error_number != EINTR) {
    throw io::io_error(path_ + " cannot be written", error_number);
  }
}

void LineOutput::commit() {
  if (!failure_.empty()) throw io::InputOutputError(failure_);
  if (file_) file_->commit(waiting_);
}

}  // namespace autoref::app
