// The league's log files, which contain network messages with their times.
//
// A file begins with the 12 bytes "SSL_LOG_FILE" and an int32 version, 1. Then come the records:
// int64 time in ns, int32 kind, int32 size, and the message. All numbers are big-endian. Files
// whose names end in .gz are written gzip-compressed; the reader detects compression from the
// content. Several logs that were appended to each other are read as one log if either all or none
// of them are compressed.
//
// A log can end with an index, which is a record of kind 6 with time 0. It contains the offset of
// each record before it (int64), the size of the index record with its header (int64), and the 7
// bytes "INDEXED".
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::league {

enum class MessageKind : std::int32_t {
  kUnknown = 1,  // "guess by parsing"
  kVision2010 = 2,
  kReferee2013 = 3,
  kVision2014 = 4,
  kTracker2020 = 5,
  kIndex2021 = 6,
};

// Thrown if a log cannot be opened, read or written. what() begins with the file's name.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LogRecord {
  std::int64_t time_ns = 0;
  std::int32_t kind = 0;  // a MessageKind, or an unknown number
  std::string message;
};

class LogWriter {
 public:
  // Creates or truncates the file; compresses it if its name ends in .gz. Throws LogError.
  explicit LogWriter(const std::filesystem::path& path);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  // Written records reach the file after every second of the messages' time, so that little more
  // than a second is lost if the program is killed. Throws LogError.
  void write(std::int64_t time_ns, MessageKind kind, std::string_view message);

  // Flushes and closes the file; nothing can be written afterwards. Throws LogError.
  void close();

 private:
  void put(std::string_view bytes);
  [[noreturn]] void fail() const;

  std::string name_;
  void* file_ = nullptr;  // a gzFile
  std::int64_t flushed_ns_ = 0;
};

// Whether a file that begins with `bytes` may be a log, compressed or not.
bool may_begin_log(std::string_view bytes);

// The point at which a file becomes unreadable. Everything before it is valid.
struct LogDamage {
  std::int64_t offset = 0;  // in bytes, in the uncompressed content
  std::string what;
};

// Reads records one by one, in bounded memory whatever the file contains.
class LogReader {
 public:
  static constexpr std::size_t kLongestMessage = std::size_t{1} << 20;  // UDP carries 64 KiB

  // Throws LogError if the file cannot be read or is not a log of version 1.
  explicit LogReader(const std::filesystem::path& path);
  ~LogReader();
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  // Reads the next record into `record`; returns false at the end, or if the file is damaged. An
  // index is skipped, whatever its size; its message is empty. A log that ends in the middle of an
  // index is not considered damaged, since no message is lost.
  bool read(LogRecord& record);

  // Offset of the last record read.
  std::int64_t offset() const { return offset_; }

  // Why reading stopped; nullopt while it has not stopped, and at the end of an intact file.
  const std::optional<LogDamage>& damage() const { return damage_; }

 private:
  std::size_t get(char* bytes, std::size_t count);
  bool fail(const std::string& what);
  void skip_index(std::size_t length);

  std::string name_;
  void* file_ = nullptr;     // a gzFile
  std::int64_t offset_ = 0;  // offset of the current record
  bool is_over_ = false;
  std::optional<LogDamage> damage_;
};

}  // namespace autoref::league
