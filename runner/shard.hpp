// The file that one run appends its rows to, and everything that a folder's files hold.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runner/rows.hpp"

namespace autoref::runner {

// An append-only file of lines, held by one process at a time. A line is written at once and is on
// the disk when append() returns.
class Shard {
 public:
  // Creates the file where there is none, locks it, and cuts off a last line without end, which a
  // killed run leaves behind. Writes `header` into an empty file. Throws InputOutputError where
  // that fails, or where another run holds the file for longer than `patience_s`.
  Shard(std::filesystem::path path, const std::string& header, double patience_s = 2.0);
  ~Shard();
  Shard(const Shard&) = delete;
  Shard& operator=(const Shard&) = delete;

  // Throws InputOutputError; then the file ends where it ended before.
  void append(const std::string& line);

 private:
  void lock(double patience_s);
  void cut_torn_line();

  std::filesystem::path path_;
  int descriptor_ = -1;
};

// A row as it stands in a file.
struct StoredRow {
  std::string id;
  std::string build;
  std::string config_hash;
  Cells cells;
};

struct StoredRows {
  std::vector<StoredRow> rows;
  int damaged = 0;  // lines whose row_crc does not fit; their games count as not played
};

// Reads every .csv in the folder, in the order of their names. Throws InputError for a file whose
// columns are not those of `format`.
StoredRows read_rows(const std::filesystem::path& games_folder, const RowFormat& format);

}  // namespace autoref::runner
