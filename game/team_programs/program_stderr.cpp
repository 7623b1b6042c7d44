#include "game/team_programs/program_stderr.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "io/errors.hpp"

namespace autoref::game {
namespace {

constexpr std::size_t kTail_bytes = 64 * 1024;
constexpr std::size_t kQuoted_bytes = 200;
constexpr int kQuotedLines = 4;

}  // namespace

ProgramStderr::ProgramStderr(int descriptor, const ProgramSpec& spec)
    : descriptor_(descriptor),
      file_name_(spec.stderr_file),
      copy_(spec.stderr_copy),
      room_(spec.limits.stderr_bytes) {
  // An earlier attempt at the game may have left a file.
  if (!file_name_.empty()) unlink(file_name_.c_str());
}

ProgramStderr::~ProgramStderr() {
  if (descriptor_ >= 0) close(descriptor_);
  if (file_ >= 0) close(file_);
}

bool ProgramStderr::drain() {
  if (descriptor_ < 0) return false;
  std::array<char, 16384> buffer{};
  const ssize_t size = read(descriptor_, buffer.data(), buffer.size());
  if (size > 0) {
    keep(buffer.data(), static_cast<std::size_t>(size));
    return true;
  }
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  close(descriptor_);
  descriptor_ = -1;
  return false;
}

void ProgramStderr::keep(const char* text, std::size_t size) {
  tail_.append(text, size);
  if (tail_.size() > 2 * kTail_bytes) tail_.erase(0, tail_.size() - kTail_bytes);
  const std::size_t written = std::min(size, room_);
  room_ -= written;
  if (written == 0) return;
  write_to_file(text, written);
  [[maybe_unused]] const ssize_t ignored = copy_ < 0 ? 0 : write(copy_, text, written);
}

// The name must be unused: the program may have put a FIFO there, or a link to a file that must not
// change.
void ProgramStderr::write_to_file(const char* text, std::size_t size) {
  if (file_name_.empty()) return;
  if (file_ < 0) file_ = open(file_name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const ssize_t written = file_ < 0 ? -1 : write(file_, text, size);
  if (written != static_cast<ssize_t>(size)) give_up_file(written < 0 ? errno : ENOSPC);
}

// A full disk costs these lines, not the game.
void ProgramStderr::give_up_file(int error_number) {
  const char* const reason = error_number == EEXIST ? "another program has created a file there"
                                                    : std::strerror(error_number);
  io::write_message(
      stderr,
      fmt::format(
          "autoref: {}: {}; the rest of the program's standard error in this game is discarded\n",
          file_name_, reason));
  file_name_.clear();
}

std::string ProgramStderr::last_lines() const {
  std::string text = tail_;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::size_t begin = text.size();
  for (int lines = 0; begin > 0; --begin) {
    if (text[begin - 1] == '\n' && ++lines == kQuotedLines) break;
  }
  begin = std::max(begin, text.size() - std::min(text.size(), kQuoted_bytes));
  text.erase(0, begin);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return (c < 32 && c != '\n') || c >= 127; },
      '?');
  return text;
}

}  // namespace autoref::game
