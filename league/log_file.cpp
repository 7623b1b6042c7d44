#include "league/log_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

namespace autoref::league {
namespace {

constexpr std::string_view kSignature = "SSL_LOG_FILE";
constexpr std::uint32_t kVersion = 1;
// Size in bytes, for the header of a record as well as of the file.
constexpr std::size_t kHeaderSize = 16;
constexpr std::size_t kBuffer = 1U << 16;  // zlib's buffer size
constexpr std::uint64_t kFlushEvery_ns = 1'000'000'000;
constexpr std::size_t kPortion = 1U << 16;  // step by which a message grows while it is read

gzFile zlib_file(void* file) { return static_cast<gzFile>(file); }

// Numbers are big-endian on every machine.
template <typename Number>
void put_number(char* bytes, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes[i] = static_cast<char>(number >> (8 * (sizeof(Number) - 1 - i)));
}

template <typename Number>
Number number_at(const char* bytes) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    number = static_cast<Number>(number << 8 | static_cast<unsigned char>(bytes[i]));
  return number;
}

using Header = std::array<char, kHeaderSize>;

bool has_signature(const Header& header) {
  return std::equal(kSignature.begin(), kSignature.end(), header.begin());
}

std::uint32_t version_of(const Header& header) {
  return number_at<std::uint32_t>(header.data() + kSignature.size());
}

std::string reason_of(void* file) {
  int code = Z_OK;
  const char* text = gzerror(zlib_file(file), &code);
  return code == Z_ERRNO ? std::strerror(errno) : text;
}

}  // namespace

bool may_begin_log(std::string_view bytes) {
  return bytes.starts_with(kSignature) || bytes.starts_with("\x1f\x8b");
}

LogWriter::LogWriter(const std::filesystem::path& path) : name_(path.string()) {
  const bool is_compressed = path.extension() == ".gz";
  // zlib's modes: 1 is the fastest level, T writes without compression.
  file_ = gzopen(name_.c_str(), is_compressed ? "wb1" : "wbT");
  if (file_ == nullptr) throw LogError(fmt::format("{}: {}", name_, std::strerror(errno)));
  gzbuffer(zlib_file(file_), kBuffer);
  Header header{};
  std::copy(kSignature.begin(), kSignature.end(), header.begin());
  put_number(header.data() + kSignature.size(), kVersion);
  put({header.data(), header.size()});
}

LogWriter::~LogWriter() {
  // Only close() reports errors: a destructor must not throw.
  if (file_ != nullptr) gzclose(zlib_file(file_));
}

void LogWriter::put(std::string_view bytes) {
  if (bytes.empty()) return;
  if (gzwrite(zlib_file(file_), bytes.data(), static_cast<unsigned>(bytes.size())) <= 0) fail();
}

void LogWriter::fail() const {
  throw LogError(fmt::format("{}: cannot be written: {}", name_, reason_of(file_)));
}

void LogWriter::write(std::int64_t time_ns, MessageKind kind, std::string_view message) {
  Header header{};
  put_number(header.data(), static_cast<std::uint64_t>(time_ns));
  put_number(header.data() + 8, static_cast<std::uint32_t>(kind));
  put_number(header.data() + 12, static_cast<std::uint32_t>(message.size()));
  put({header.data(), header.size()});
  put(message);
  // The difference is unsigned, since arbitrary times may be far apart. A clock that was set back
  // also causes a flush.
  const std::uint64_t since_ns =
      static_cast<std::uint64_t>(time_ns) - static_cast<std::uint64_t>(flushed_ns_);
  if (since_ns < kFlushEvery_ns) return;
  flushed_ns_ = time_ns;
  if (gzflush(zlib_file(file_), Z_SYNC_FLUSH) != Z_OK) fail();
}

void LogWriter::close() {
  const int result = gzclose(zlib_file(std::exchange(file_, nullptr)));
  if (result == Z_OK) return;
  throw LogError(fmt::format("{}: cannot be written: {}", name_,
                             result == Z_ERRNO ? std::strerror(errno) : zError(result)));
}

LogReader::LogReader(const std::filesystem::path& path) : name_(path.string()) {
  if (std::filesystem::is_directory(path)) throw LogError(name_ + ": is a folder, not a log");
  file_ = gzopen(name_.c_str(), "rb");
  if (file_ == nullptr) throw LogError(fmt::format("{}: {}", name_, std::strerror(errno)));
  gzbuffer(zlib_file(file_), kBuffer);
  Header header{};
  const std::size_t size = get(header.data(), header.size());
  std::string mistake;
  if (size == 0) {
    mistake = "is empty";
  } else if (size < header.size() || !has_signature(header)) {
    mistake = fmt::format("is not an SSL log: the first bytes are not {}", kSignature);
  } else if (version_of(header) != kVersion) {
    mistake = fmt::format("has version {}, at byte {}; only version {} is supported",
                          version_of(header), kSignature.size(), kVersion);
  }
  if (mistake.empty()) return;
  gzclose(zlib_file(file_));
  throw LogError(fmt::format("{}: {}", name_, mistake));
}

LogReader::~LogReader() { gzclose(zlib_file(file_)); }

// Reads up to `count` bytes and returns how many it got.
std::size_t LogReader::get(char* bytes, std::size_t count) {
  const int got = gzread(zlib_file(file_), bytes, static_cast<unsigned>(count));
  return got > 0 ? static_cast<std::size_t>(got) : 0;
}

bool LogReader::fail(const std::string& what) {
  damage_ = LogDamage{offset_, what};
  return false;
}

// An index has 8 bytes per record, so the index of a game's log takes several megabytes.
void LogReader::skip_index(std::size_t length) {
  std::vector<char> portion(std::min(kPortion, length));
  while (length > 0 && !is_over_) {
    const std::size_t count = std::min(portion.size(), length);
    is_over_ = get(portion.data(), count) < count;
    length -= count;
  }
}

bool LogReader::read(LogRecord& record) {
  if (damage_ || is_over_) return false;
  offset_ = gztell(zlib_file(file_));
  Header header{};
  std::size_t size = get(header.data(), header.size());
  // If another log has been appended to this one, its header is skipped.
  while (size == header.size() && has_signature(header)) {
    if (version_of(header) != kVersion)
      return fail(fmt::format("a log of version {} follows; only version {} is supported",
                              version_of(header), kVersion));
    offset_ = gztell(zlib_file(file_));
    size = get(header.data(), header.size());
  }
  int code = Z_OK;
  gzerror(zlib_file(file_), &code);
  if (size < header.size()) {
    if (code != Z_OK) return fail(fmt::format("cannot be decompressed: {}", reason_of(file_)));
    return size == 0 ? false : fail("ends in the middle of a record's header");
  }
  record.time_ns = static_cast<std::int64_t>(number_at<std::uint64_t>(header.data()));
  record.kind = static_cast<std::int32_t>(number_at<std::uint32_t>(header.data() + 8));
  const std::size_t length = number_at<std::uint32_t>(header.data() + 12);
  record.message.clear();
  if (record.kind == static_cast<std::int32_t>(MessageKind::kIndex2021)) {
    skip_index(length);
    return true;
  }
  if (length > kLongestMessage) {
    return fail(
        fmt::format("a message of {} bytes exceeds the maximum of {}", length, kLongestMessage));
  }
  // The message grows with the data actually read, so a damaged length does not allocate memory for
  // nothing.
  while (record.message.size() < length) {
    const std::size_t had = record.message.size();
    const std::size_t portion = std::min(kPortion, length - had);
    record.message.resize(had + portion);
    if (get(record.message.data() + had, portion) == portion) continue;
    return fail(fmt::format("ends in the middle of a message of {} bytes", length));
  }
  return true;
}

}  // namespace autoref::league
