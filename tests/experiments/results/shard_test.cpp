#include "experiments/results/shard.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>

#include "experiments/kinds/sweep/sweep.hpp"
#include "game/settings/game_settings.hpp"
#include "io/checksum.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

TEST(Shard, StartsWithASingleHeader) {
  const TemporaryFolder folder;
  Shard(folder / "s.csv", "head").append("row");
  Shard(folder / "s.csv", "head").append("more");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\nmore\n");
}

TEST(Shard, HasWrittenRowsBeforeTheyAreSynced) {
  const TemporaryFolder folder;
  Shard shard(folder / "s.csv", "head");
  shard.write("row");
  shard.write("more");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\nmore\n");
  shard.sync();
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\nmore\n");
}

TEST(Shard, TruncatesAnIncompleteLastLine) {
  const TemporaryFolder folder;
  write_content(folder / "s.csv", "head\nrow\nto");
  Shard(folder / "s.csv", "head").append("more");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\nmore\n");
}

TEST(Shard, RewritesAnIncompleteHeader) {
  const TemporaryFolder folder;
  write_content(folder / "s.csv", "he");
  const Shard shard(folder / "s.csv", "head");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\n");
}

TEST(Shard, BelongsToOneRunAtATime) {
  const TemporaryFolder folder;
  {
    const Shard first(folder / "s.csv", "head");
    EXPECT_THROW(Shard(folder / "s.csv", "head", 0.05), io::InputOutputError);
  }
  EXPECT_NO_THROW(Shard(folder / "s.csv", "head", 0.05));
}

TEST(Shard, ReportsWhyAFileCannotBeWritten) {
  try {
    const Shard shard("/nonexistent/s.csv", "head");
    FAIL();
  } catch (const io::InputOutputError& error) {
    EXPECT_STREQ(error.what(), "/nonexistent/s.csv cannot be written: No such file or directory");
  }
}

// Simulates a full disk: limits the size of this process's files to `bytes` during its lifetime.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &former_);
    const rlimit small{bytes, former_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &former_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit former_{};
  void (*handler_)(int) = nullptr;
};

TEST(Shard, RemovesAnIncompleteRowIfTheDiskIsFull) {
  const TemporaryFolder folder;
  Shard shard(folder / "s.csv", "head");
  {
    const SmallDisk disk(8);
    EXPECT_THROW(shard.append("row"), io::InputOutputError);
  }
  EXPECT_EQ(content_of(folder / "s.csv"), "head\n");
  shard.append("row");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\n");
}

TEST(Shard, KeepsEarlierRowsIfTheDiskIsFull) {
  const TemporaryFolder folder;
  Shard shard(folder / "s.csv", "head");
  shard.write("row");
  {
    const SmallDisk disk(12);
    EXPECT_THROW(shard.write("another"), io::InputOutputError);
  }
  shard.sync();
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\n");
}

TEST(Shard, RefusesDevices) { EXPECT_THROW(Shard("/dev/full", "head"), io::InputOutputError); }

const RowFormat kShardFormat({"b.robots"});

std::string row_line() {
  const ScheduledGame game = small_sweep().as<Sweep>()->games().front();
  GameRow row = row_of(game);
  row.record = fake_game(game::resolved(game.settings.combined()));
  return kShardFormat.line(row);
}

TEST(ReadRows, CountsDamagedLinesAndKeepsTheOthers) {
  const TemporaryFolder folder;
  std::string damaged = row_line();
  damaged[0] ^= 1;
  write_content(folder / "shard-0-of-1.csv", io::csv_line(kShardFormat.names()) + "\n" + damaged +
                                                 "\n\n" + row_line() + "\ntorn");
  const StoredRows stored = read_rows(folder.path(), kShardFormat);
  ASSERT_EQ(stored.rows.size(), 1U);
  EXPECT_TRUE(row_line().starts_with(stored.rows.begin()->first + ","));
  ASSERT_EQ(stored.damaged.size(), 2U);
  EXPECT_EQ(stored.damaged[0].at, "games/shard-0-of-1.csv:2");
}

TEST(ReadRows, RefusesAPipeThatNobodyWritesTo) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "shard-0-of-1.csv").c_str(), 0600), 0);
  EXPECT_THROW(read_rows(folder.path(), RowFormat({})), io::InputError);
}

// A line in which one cell is replaced and the checksum is valid.
std::string line_with(const char* column, const char* cell) {
  const io::Cells names = kShardFormat.names();
  io::Cells cells = io::csv_cells(row_line()).value();
  const auto at = std::find(names.begin(), names.end(), column) - names.begin();
  cells[static_cast<std::size_t>(at)] = cell;
  cells.pop_back();
  return io::csv_line(cells) + "," + io::crc_text(io::csv_line(cells));
}

TEST(ReadRows, CountsALineAsDamagedIfACellIsInvalid) {
  for (const char* column :
       {"pair", "side_a", "seed", "goals_a", "goal_diff", "end_reason", "status", "shots_a",
        "shootout_b", "sim_s", "frames", "state_hash", "config_hash", "wall_s"}) {
    const TemporaryFolder folder;
    write_content(folder / "shard-0-of-1.csv",
                  io::csv_line(kShardFormat.names()) + "\n" + line_with(column, "many") + "\n");
    EXPECT_EQ(read_rows(folder.path(), kShardFormat).damaged.size(), 1U) << column;
  }
}

TEST(ReadRows, RefusesAFileWithOtherColumns) {
  const TemporaryFolder folder;
  write_content(folder / "shard-0-of-1.csv", io::csv_line(RowFormat({"a.robots"}).names()) + "\n");
  EXPECT_THROW(read_rows(folder.path(), RowFormat({"b.robots"})), io::InputError);
}

}  // namespace
}  // namespace autoref::experiments
