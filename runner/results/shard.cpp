#include "runner/results/shard.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "runner/io/csv.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

InputOutputError cannot_write(const fs::path& path) {
  return io_error(fmt::format("{} cannot be written", path.string()), errno);
}

}  // namespace

std::string ShardIndex::name() const { return fmt::format("{}/{}", number, of); }

std::string ShardIndex::file_name() const { return fmt::format("shard-{}-of-{}.csv", number, of); }

bool ShardIndex::has(std::size_t unit) const {
  return unit % static_cast<std::size_t>(of) == static_cast<std::size_t>(number);
}

ShardIndex shard_index_of(const std::string& text) {
  constexpr int kMost = 10000;
  ShardIndex position;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, position.number);
  const bool has_slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto of = std::from_chars(has_slash ? number.ptr + 1 : end, end, position.of);
  if (has_slash && of.ec == std::errc() && of.ptr == end && position.number >= 0 &&
      position.of <= kMost && position.number < position.of)
    return position;
  throw std::invalid_argument(
      fmt::format("expected I/N, such as 0/4 to 3/4, with N up to {}; found '{}'", kMost, text));
}

Shard::Shard(fs::path path, const std::string& header, double patience_s) : path_(std::move(path)) {
  // O_APPEND: every write goes to the end, wherever a torn line was cut off.
  descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw cannot_write(path_);
  try {
    if (!fs::is_regular_file(path_)) {
      throw InputOutputError(fmt::format("{} is not a regular file", path_.string()));
    }
    lock(patience_s);
    cut_torn_line();
    synced_bytes_ = lseek(descriptor_, 0, SEEK_END);
    if (synced_bytes_ == 0) append(header);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Shard::~Shard() { close(descriptor_); }

// Retries, since the lock of a run that was just killed may take a moment to be released.
void Shard::lock(double patience_s) {
  const auto until = Clock::now() + std::chrono::duration<double>(patience_s);
  while (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) throw cannot_write(path_);
    if (Clock::now() > until) {
      throw InputOutputError(
          fmt::format("{} is in use: another autoref run is writing to this folder; wait for it or "
                      "choose another "
                      "folder with -o",
                      path_.string()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void Shard::cut_torn_line() {
  const std::string text = read_file(path_).value_or("");
  const std::size_t last_end = text.rfind('\n');
  const std::size_t whole = last_end == std::string::npos ? 0 : last_end + 1;
  if (whole == text.size()) return;
  if (ftruncate(descriptor_, static_cast<off_t>(whole)) != 0) throw cannot_write(path_);
}

void Shard::write(const std::string& line) {
  const off_t end = lseek(descriptor_, 0, SEEK_END);
  const std::string text = line + "\n";
  // One write() per row, so a crash can tear only the last one.
  const ssize_t count = ::write(descriptor_, text.data(), text.size());
  if (count == static_cast<ssize_t>(text.size())) return;
  fail(count >= 0 ? ENOSPC : errno, end);
}

void Shard::sync() {
  if (fdatasync(descriptor_) != 0) fail(errno, synced_bytes_);
  synced_bytes_ = lseek(descriptor_, 0, SEEK_END);
}

void Shard::append(const std::string& line) {
  write(line);
  sync();
}

void Shard::fail(int error_number, std::int64_t end) {
  // If this fails too, the next run truncates the incomplete line.
  [[maybe_unused]] const int ignored = ftruncate(descriptor_, static_cast<off_t>(end));
  throw io_error(fmt::format("{} cannot be written", path_.string()), error_number);
}

StoredRows read_rows(const fs::path& games_folder, const RowFormat& format) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(games_folder)) {
    if (entry.path().extension() != ".csv") continue;
    if (entry.exists() && !entry.is_regular_file()) {
      throw InputError({entry.path().string()}, "",
                       "is not a regular file, so rows cannot be read from it; remove it");
    }
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  StoredRows stored;
  for (const fs::path& file : files) {
    const std::string text = read_file(file).value_or("");
    const std::vector<std::string_view> lines = complete_lines(text);
    // Only complete lines are read, so a row that another process is writing is merely not there
    // yet.
    if (lines.empty()) continue;
    if (lines.front() != csv_line(format.names())) {
      throw InputError(
          {file.string(), 1, 1}, "",
          "these rows have other columns, so they belong to another scenario or version; "
          "choose another folder with -o, or remove this one");
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
      std::optional<GameRow> row = format.read(lines[i]);
      if (row) {
        stored.rows.push_back(std::move(*row));
      } else {
        ++stored.damaged;
      }
    }
  }
  return stored;
}

}  // namespace autoref::runner
