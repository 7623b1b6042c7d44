// Appends the rows of a run to the run's file, and reads all rows of a results folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/results/row_format.hpp"

namespace autoref::experiments {

// Names of the contents of a results folder.
inline constexpr const char* kGamesFolder = "games";             // one .csv of rows per shard
inline constexpr const char* kEffectiveFile = "effective.yaml";  // scenario with all settings
inline constexpr const char* kResultsFile = "results.csv";

// The index of one of several runs that share an experiment's games, on one machine or several.
struct ShardIndex {
  int number = 0;  // number of the shard, from 0
  int of = 1;

  std::string name() const;       // "0/1"
  std::string file_name() const;  // "shard-0-of-1.csv"
  // Whether this shard plays the games of `unit`. Of every `of` successive units, each shard plays
  // one. If `variants` is not 0 (ScheduledGame::variant), the assignment of units to shards changes
  // from time to time, so that no shard always gets the same teams or values.
  bool has(std::size_t unit, std::size_t variants = 0) const;
};

// Parses text such as "0/4". Throws std::invalid_argument, with the expected format, if it is
// invalid.
ShardIndex shard_index_of(const std::string& text);

// An append-only file of lines, locked by one process at a time. Other programs ignore the lock:
// editors, for example, replace a file with a new one of the same name.
class Shard {
 public:
  // Creates the file if it does not exist, locks it, and removes an incomplete last line, which a
  // killed run may leave behind. Writes `header` to an empty file. Throws InputOutputError if that
  // fails or if another run keeps the file locked for longer than `patience_s`.
  Shard(std::filesystem::path path, const std::string& header, double patience_s = 2.0);
  ~Shard();
  Shard(const Shard&) = delete;
  Shard& operator=(const Shard&) = delete;

  // Adds a line. The line survives a crash of this process, but not necessarily a crash of the
  // machine. Throws InputOutputError if it cannot be written; the file is then unchanged.
  void write(const std::string& line);

  // Returns once all lines are on the disk. Throws InputOutputError if that fails; the file then
  // ends with the last line known to be on the disk.
  void sync();

  // Adds a line and returns once it is on the disk. Throws like write() and sync().
  void append(const std::string& line);

  // Whether the path still names the file and all lines are in it. False once another program has
  // replaced, removed, moved or shortened the file; lines written after that are lost.
  bool is_intact() const;

  // Continues in the file that the path names now. If there is none, creates it and its folder.
  // Adds the lines of `lines` and of the former file that are missing from this file, and returns
  // once they are on the disk. Throws like the constructor and sync().
  void restore(const std::vector<std::string>& lines);

 private:
  void open_file();
  void lock();
  void cut_torn_line();
  [[noreturn]] void fail(int error_number, std::int64_t end);

  std::filesystem::path path_;
  std::string header_;
  double patience_s_;
  int descriptor_ = -1;
  std::int64_t bytes_ = 0;  // length of all lines
  std::int64_t synced_bytes_ = 0;
};

// A line that RowFormat::read() rejects; its game counts as unplayed.
struct DamagedRow {
  std::string at;       // "games/shard-0-of-1.csv:5"
  std::string game_id;  // the row's first cell, which may itself be damaged
};

struct StoredRows {
  RowsInFiles rows;
  std::vector<DamagedRow> damaged;  // except those whose games have another row
};

// Reads every .csv file in the folder, in order of file name, line by line. Throws InputError if a
// file's columns differ from those of `format`.
StoredRows read_rows(const std::filesystem::path& games_folder, const RowFormat& format);

}  // namespace autoref::experiments
