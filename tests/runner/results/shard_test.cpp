#include "runner/results/shard.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "runner/io/csv.hpp"
#include "runner/io/errors.hpp"
#include "tests/runner/batch/fake_games.hpp"

namespace autoref::runner {
namespace {

TEST(Shard, BeginsWithTheHeader) {
  const TemporaryFolder folder;
  Shard(folder / "s.csv", "head").append("row");
  Shard(folder / "s.csv", "head").append("more");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\nmore\n");
}

TEST(Shard, CutsOffALineThatAKilledRunLeftWithoutItsEnd) {
  const TemporaryFolder folder;
  write_content(folder / "s.csv", "head\nrow\nto");
  Shard(folder / "s.csv", "head").append("more");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\nmore\n");
}

TEST(Shard, WritesATornHeaderAnew) {
  const TemporaryFolder folder;
  write_content(folder / "s.csv", "he");
  const Shard shard(folder / "s.csv", "head");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\n");
}

TEST(Shard, BelongsToOneRunAtATime) {
  const TemporaryFolder folder;
  {
    const Shard first(folder / "s.csv", "head");
    EXPECT_THROW(Shard(folder / "s.csv", "head", 0.05), InputOutputError);
  }
  EXPECT_NO_THROW(Shard(folder / "s.csv", "head", 0.05));
}

TEST(Shard, SaysWhyAFileCannotBeWritten) {
  try {
    const Shard shard("/nonexistent/s.csv", "head");
    FAIL();
  } catch (const InputOutputError& error) {
    EXPECT_STREQ(error.what(), "/nonexistent/s.csv cannot be written: No such file or directory");
  }
}

// Files of this process may not grow beyond `bytes` while this lives: like a disk that is full.
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

TEST(Shard, LeavesNoPartOfARowOnAFullDisk) {
  const TemporaryFolder folder;
  Shard shard(folder / "s.csv", "head");
  {
    const SmallDisk disk(8);
    EXPECT_THROW(shard.append("row"), InputOutputError);
  }
  EXPECT_EQ(content_of(folder / "s.csv"), "head\n");
  shard.append("row");
  EXPECT_EQ(content_of(folder / "s.csv"), "head\nrow\n");
}

TEST(Shard, IsNoDevice) { EXPECT_THROW(Shard("/dev/full", "head"), InputOutputError); }

TEST(ReadRows, CountsDamagedLinesAndKeepsTheOthers) {
  const TemporaryFolder folder;
  const RowFormat format({"b.robots"});
  const ScheduledGame game = scheduled_games(std::get<Sweep>(small_sweep().content)).front();
  const std::string line = format.line(game, outcome_of(fake_game(game.configuration)), {});
  std::string damaged = line;
  damaged[0] ^= 1;
  write_content(folder / "shard-0-of-1.csv",
                csv_line(format.columns()) + "\n" + damaged + "\n\n" + line + "\ntorn");
  const StoredRows stored = read_rows(folder.path(), format);
  ASSERT_EQ(stored.rows.size(), 1U);
  EXPECT_EQ(stored.rows[0].id, game.id);
  EXPECT_EQ(stored.damaged, 2);
}

TEST(ReadRows, RefusesAPipeThatNobodyWritesTo) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "shard-0-of-1.csv").c_str(), 0600), 0);
  EXPECT_THROW(read_rows(folder.path(), RowFormat({})), InputError);
}

TEST(ReadRows, CountsALineWhoseGoalsAreNoNumbersAsDamaged) {
  const TemporaryFolder folder;
  const RowFormat format({"b.robots"});
  const ScheduledGame game = scheduled_games(std::get<Sweep>(small_sweep().content)).front();
  for (const char* column : {"goals_a", "goal_diff", "shootout_b"}) {
    Cells outcome = outcome_of(fake_game(game.configuration));
    outcome[format.column(column) - format.first_outcome()] = "many";
    write_content(folder / "shard-0-of-1.csv",
                  csv_line(format.columns()) + "\n" + format.line(game, outcome, {}) + "\n");
    EXPECT_EQ(read_rows(folder.path(), format).damaged, 1) << column;
  }
}

TEST(ReadRows, RefusesAFileWithOtherColumns) {
  const TemporaryFolder folder;
  write_content(folder / "shard-0-of-1.csv", csv_line(RowFormat({"a.robots"}).columns()) + "\n");
  EXPECT_THROW(read_rows(folder.path(), RowFormat({"b.robots"})), InputError);
}

}  // namespace
}  // namespace autoref::runner
