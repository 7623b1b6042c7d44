// The file that one run appends its rows to, and everything that a folder's files hold.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/results/row_format.hpp"

namespace autoref::runner {

// What a folder of results holds.
inline constexpr const char* kGamesFolder = "games";             // a .csv of rows per shard
inline constexpr const char* kEffectiveFile = "effective.yaml";  // the scenario, spelt out
inline constexpr const char* kResultsFile = "results.csv";

// One of several runs that share an experiment's games between them, on one machine or many.
struct ShardIndex {
  int number = 0;  // from 0
  int of = 1;

  std::string name() const;       // "0/1"
  std::string file_name() const;  // "shard-0-of-1.csv"
  // Whether the games of that unit (schedule.hpp) are this shard's.
  bool has(std::size_t unit) const;
};

// Of "0/4". Throws std::invalid_argument that says what is expected.
ShardIndex shard_index_of(const std::string& text);

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

struct StoredRows {
  std::vector<GameRow> rows;
  int damaged = 0;  // lines that RowFormat::read() refused; their games count as not played
};

// Reads every .csv file in the folder, in the order of their names. Throws InputError if a file's
// columns are not those of `format`.
StoredRows read_rows(const std::filesystem::path& games_folder, const RowFormat& format);

}  // namespace autoref::runner
