#include "experiments/results/shard.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

io::InputOutputError cannot_write(const fs::path& path) {
  return io::io_error(fmt::format("{} cannot be written", path.string()), errno);
}

// The complete lines of an open file, even if it has been renamed.
std::vector<std::string> lines_of(int descriptor) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(lseek(descriptor, 0, SEEK_END), 0)),
                   '\0');
  std::size_t size = 0;
  ssize_t count = 0;
  while (size < text.size() && (count = pread(descriptor, text.data() + size, text.size() - size,
                                              static_cast<off_t>(size))) > 0)
    size += static_cast<std::size_t>(count);
  text.resize(size);
  const std::vector<std::string_view> lines = io::complete_lines(text);
  return {lines.begin(), lines.end()};
}

std::vector<fs::path> row_files(const fs::path& games_folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(games_folder)) {
    if (entry.path().extension() != ".csv") continue;
    if (entry.exists() && !entry.is_regular_file()) {
      throw io::InputError({entry.path().string()}, "",
                           "is not a regular file, so rows cannot be read from it; remove it");
    }
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Reads only complete lines, so a row that another process is still writing is simply ignored.
void add_rows(const fs::path& file, const RowFormat& format, StoredRows& stored) {
  const std::string header = io::csv_line(format.names());
  std::size_t number = 0;
  io::LinesAsWritten lines([&](std::string_view line) {
    if (++number == 1) {
      if (line == header) return;
      throw io::InputError({file.string(), 1, 1}, "",
                           "these rows have different columns, so they belong to another scenario "
                           "or version; choose another folder with -o, or remove this one");
    }
    std::optional<GameRow> row = format.read(line);
    if (row) {
      std::string id = row->game_id;
      stored.rows.emplace(std::move(id), std::move(*row));
    } else {
      stored.damaged.push_back(
          {fmt::format("{}/{}:{}", kGamesFolder, file.filename().string(), number),
           io::first_cell(line)});
    }
  });
  io::read_pieces(file, [&lines](std::string_view piece) { lines.add(piece); });
}

// Drops the damaged rows of a game if it has intact rows of every build, since the build of a
// damaged row is unknown.
void drop_replaced(StoredRows& stored) {
  std::set<std::string_view> builds;
  std::map<std::string_view, std::set<std::string_view>> played;
  for (const auto& [id, row] : stored.rows) {
    builds.insert(row.circumstances.build);
    played[id].insert(row.circumstances.build);
  }
  std::erase_if(stored.damaged, [&](const DamagedRow& row) {
    const auto found = played.find(row.game_id);
    return found != played.end() && found->second.size() == builds.size();
  });
}

}  // namespace

std::string ShardIndex::name() const { return fmt::format("{}/{}", number, of); }

std::string ShardIndex::file_name() const { return fmt::format("shard-{}-of-{}.csv", number, of); }

bool ShardIndex::has(std::size_t unit, std::size_t variants) const {
  const auto shards = static_cast<std::size_t>(of);
  // Without the shift, every shard would get the same variants again after a number of units equal
  // to the least common multiple of `of` and `variants`.
  const std::size_t shift = variants == 0 ? 0 : unit / std::lcm(variants, shards);
  return (unit + shift) % shards == static_cast<std::size_t>(number);
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

Shard::Shard(fs::path path, const std::string& header, double patience_s)
    : path_(std::move(path)), header_(header), patience_s_(patience_s) {
  open_file();
}

Shard::~Shard() { close(descriptor_); }

void Shard::open_file() {
  // O_APPEND: every write goes to the end, even after a torn line has been cut off.
  descriptor_ = io::open_regular_file(path_, O_RDWR | O_CREAT | O_APPEND);
  if (descriptor_ < 0) throw cannot_write(path_);
  try {
    lock();
    cut_torn_line();
    bytes_ = synced_bytes_ = lseek(descriptor_, 0, SEEK_END);
    if (bytes_ == 0) append(header_);
  } catch (...) {
    close(descriptor_);
    descriptor_ = -1;
    throw;
  }
}

// Retries, since it may take a moment until the lock of a run that was just killed is released.
void Shard::lock() {
  const auto until = Clock::now() + std::chrono::duration<double>(patience_s_);
  while (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) throw cannot_write(path_);
    if (Clock::now() > until) {
      throw io::InputOutputError(
          fmt::format("{} is in use: another autoref run is writing to this folder; wait for it or "
                      "choose another "
                      "folder with -o",
                      path_.string()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void Shard::cut_torn_line() {
  const std::string text = io::read_file(path_).value_or("");
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
  bytes_ = end + std::max<off_t>(count, 0);
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

bool Shard::is_intact() const {
  return io::is_open_as(path_, descriptor_) && lseek(descriptor_, 0, SEEK_END) >= bytes_;
}

void Shard::restore(const std::vector<std::string>& lines) {
  std::vector<std::string> wanted = lines_of(descriptor_);
  wanted.insert(wanted.end(), lines.begin(), lines.end());
  if (!io::is_open_as(path_, descriptor_)) {
    io::create_folder(path_.parent_path());
    const int former = descriptor_;
    try {
      open_file();
    } catch (...) {
      descriptor_ = former;
      throw;
    }
    close(former);
  }
  std::vector<std::string> present = lines_of(descriptor_);
  if (present.empty() || present.front() != header_) {
    // Rows without their header cannot be assigned to columns.
    if (ftruncate(descriptor_, 0) != 0) throw cannot_write(path_);
    write(header_);
    present = {header_};
  }
  std::set<std::string> known(present.begin(), present.end());
  for (const std::string& line : wanted) {
    if (known.insert(line).second) write(line);
  }
  sync();
  bytes_ = synced_bytes_;
}

void Shard::fail(int error_number, std::int64_t end) {
  // If this fails too, the next run truncates the incomplete line.
  [[maybe_unused]] const int ignored = ftruncate(descriptor_, static_cast<off_t>(end));
  bytes_ = end;
  throw io::io_error(fmt::format("{} cannot be written", path_.string()), error_number);
}

StoredRows read_rows(const fs::path& games_folder, const RowFormat& format) {
  StoredRows stored;
  for (const fs::path& file : row_files(games_folder)) add_rows(file, format, stored);
  if (!stored.damaged.empty()) drop_replaced(stored);
  return stored;
}

}  // namespace autoref::experiments
