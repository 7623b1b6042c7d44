#include "io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "io/errors.hpp"

namespace autoref::io {
namespace {

constexpr mode_t kNewFileMode = 0666;

std::string_view kind_of_file(mode_t mode) {
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISLNK(mode)) return "a symbolic link";
  return "a device";
}

InputOutputError not_a_file(const std::filesystem::path& path, mode_t mode) {
  return InputOutputError(fmt::format("{} is {} where a file is expected; remove it", path.string(),
                                      kind_of_file(mode)));
}

// Call this before opening a file: if it is a device, opening it can have effects.
void refuse_other_kinds(const std::filesystem::path& path, int flags) {
  struct stat named {};
  const bool is_followed = (flags & O_NOFOLLOW) == 0;
  const int result = is_followed ? stat(path.c_str(), &named) : lstat(path.c_str(), &named);
  if (result != 0 || S_ISREG(named.st_mode)) return;
  throw not_a_file(path, named.st_mode);
}

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // the limit of Linux

// Resolves links, "." and "..". The file need not exist; the last component may be a dangling link.
fs::path resolved(fs::path path) {
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    const fs::path target = fs::read_symlink(path, error);
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  path = fs::absolute(path, error);
  const fs::path whole = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : whole;
}

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestUserFile = 10'000'000;
constexpr std::size_t kLongestFile = 4'000'000'000;
constexpr double kPatience_s = 60;  // many shards may write their results at once

InputOutputError cannot_write(const fs::path& path) {
  return io_error(fmt::format("{} cannot be written", path.string()), errno);
}

// Closes a descriptor.
class OpenInput {
 public:
  explicit OpenInput(int descriptor) : descriptor_(descriptor) {}
  ~OpenInput() { close(descriptor_); }
  OpenInput(const OpenInput&) = delete;
  OpenInput& operator=(const OpenInput&) = delete;

 private:
  int descriptor_;
};

// Calls `take` with the content, piece by piece. Returns 0 or the error number: EFBIG if there are
// more than `most` bytes (as in /dev/zero).
int take_pieces(int descriptor, std::size_t most, const TakePiece& take) {
  if (descriptor < 0) return errno;
  const OpenInput input(descriptor);
  std::array<char, 65536> buffer{};
  std::size_t size = 0;
  ssize_t count = 0;
  while (size <= most && ((count = read(descriptor, buffer.data(), buffer.size())) > 0 ||
                          (count < 0 && errno == EINTR))) {
    if (count < 0) continue;
    take({buffer.data(), static_cast<std::size_t>(count)});
    size += static_cast<std::size_t>(count);
  }
  if (size > most) return EFBIG;
  return count < 0 ? errno : 0;
}

TakePiece append_to(std::string& text) {
  return [&text](std::string_view piece) { text += piece; };
}

}  // namespace

int open_regular_file(const std::filesystem::path& path, int flags) {
  refuse_other_kinds(path, flags);
  const int descriptor =
      open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, kNewFileMode);
  struct stat opened {};
  if (descriptor < 0 || (fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode)))
    return descriptor;
  // The file has been replaced since the first check.
  close(descriptor);
  throw not_a_file(path, opened.st_mode);
}

bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  // equivalent() compares device and inode, so it also recognises hard links, but fails for files
  // that do not exist yet.
  return fs::equivalent(one, other, error) || resolved(one) == resolved(other);
}

bool is_open_as(const fs::path& path, int descriptor) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode) &&
         stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

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

std::string read_user_file(const fs::path& path) {
  std::string text;
  const int error_number =
      take_pieces(open(path.c_str(), O_RDONLY | O_CLOEXEC), kLongestUserFile, append_to(text));
  if (error_number == 0) return text;
  throw InputError(
      {path.string()}, "",
      fmt::format("the file cannot be read: {}", std::generic_category().message(error_number)));
}

bool read_pieces(const fs::path& path, const TakePiece& take) {
  const int error_number = take_pieces(open_regular_file(path, O_RDONLY), kLongestFile, take);
  if (error_number == ENOENT) return false;
  if (error_number == 0) return true;
  throw io_error(fmt::format("{} cannot be read", path.string()), error_number);
}

std::optional<std::string> read_file(const fs::path& path) {
  std::string text;
  return read_pieces(path, append_to(text)) ? std::optional(std::move(text)) : std::nullopt;
}

void write_all(int descriptor, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw cannot_write(path);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

ssize_t write_without_signal(int descriptor, std::string_view bytes) {
  sigset_t pipe_signal;
  sigset_t former;
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe_signal, &former);
  const ssize_t written = write(descriptor, bytes.data(), bytes.size());
  const int error_number = errno;
  if (written < 0 && error_number == EPIPE) {
    const timespec now{};
    sigtimedwait(&pipe_signal, nullptr, &now);
  }
  pthread_sigmask(SIG_SETMASK, &former, nullptr);
  errno = error_number;
  return written;
}

PendingFile::PendingFile(fs::path path, FileKind kind, double patience_s)
    : kind_(kind), path_(std::move(path)) {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  was_missing_ = !fs::exists(status);
  is_file_ = kind == FileKind::kFile || was_missing_ || fs::is_regular_file(status);
  const bool is_growing = kind == FileKind::kGrowing;
  if (is_file_ && is_growing) path_ = resolved(path_);
  part_ = path_;
  if (is_file_ && !is_growing) part_ += ".part";
  if (is_file_) {
    wait_for_part(patience_s);
  } else {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) throw cannot_write(path_);
  }
}

// The temporary file always has the same name, so leftovers of a killed process are overwritten. A
// lock (flock) distinguishes them from a file that another process is still writing.
void PendingFile::wait_for_part(double patience_s) {
  const auto until = Clock::now() + std::chrono::duration<double>(patience_s);
  while (grows_elsewhere() || !take_part()) {
    if (Clock::now() > until) {
      throw InputOutputError(fmt::format("{} is in use: another process writes {}", part_.string(),
                                         is_direct() ? "it" : path_.string()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

// Whether another process writes to the file itself. AutoRef's own files do not grow.
bool PendingFile::grows_elsewhere() const {
  if (kind_ != FileKind::kFileOrPipe) return false;
  const int descriptor = open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool is_locked = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return is_locked;
}

bool PendingFile::take_part() {
  const int follow = is_direct() ? 0 : O_NOFOLLOW;
  descriptor_ = open_regular_file(part_, O_WRONLY | O_CREAT | follow);
  if (descriptor_ < 0) throw cannot_write(path_);
  const bool is_locked = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
  const bool is_busy = !is_locked && (errno == EWOULDBLOCK || errno == EINTR);
  // The previous holder of the lock may have renamed or removed the file in the meantime.
  const bool is_gone = is_locked && !is_open_as(part_, descriptor_);
  if (is_locked && !is_gone && (is_direct() || ftruncate(descriptor_, 0) == 0)) return true;
  const int error_number = errno;
  close(descriptor_);
  descriptor_ = -1;
  if (is_busy || is_gone) return false;
  throw io_error(fmt::format("{} cannot be written", path_.string()), error_number);
}

PendingFile::~PendingFile() {
  if (descriptor_ < 0) return;
  // Unlink while the lock is held: afterwards the name may already belong to another process.
  if (!is_direct() || (was_missing_ && !has_begun_)) unlink(part_.c_str());
  close(descriptor_);
}

void PendingFile::begin() {
  if (!is_direct() || std::exchange(has_begun_, true)) return;
  // Only files have a length that can be set.
  if (ftruncate(descriptor_, 0) != 0 && errno != EINVAL) throw cannot_write(path_);
}

void PendingFile::write(std::string_view text) {
  begin();
  write_all(descriptor_, text, path_);
}

void PendingFile::commit(std::string_view text) {
  write(text);
  if (is_direct()) return;
  // rename() replaces the file atomically: readers see either the old or the new content, never
  // parts of it. Without fsync(), a power failure could leave an empty file under that name.
  if (fsync(descriptor_) != 0 || rename(part_.c_str(), path_.c_str()) != 0) {
    throw cannot_write(path_);
  }
  close(descriptor_);
  descriptor_ = -1;
}

void replace_file(const fs::path& path, std::string_view text) {
  if (read_file(path) == text) return;
  PendingFile file(path, FileKind::kFile, kPatience_s);
  // Another run of the same experiment may just have written the same content.
  if (read_file(path) != text) file.commit(text);
}

void create_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && !fs::is_directory(path, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    throw InputOutputError(
        fmt::format("the folder {} cannot be created: {}", path.string(), error.message()));
  }
}

}  // namespace autoref::io
