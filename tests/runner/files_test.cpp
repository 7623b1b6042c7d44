#include "runner/files.hpp"

#include <gtest/gtest.h>

#include "runner/errors.hpp"
#include "tests/runner/temporary_folder.hpp"

namespace autoref::runner {
namespace {

TEST(PendingFile, AppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  {
    PendingFile file(folder / "x");
    EXPECT_FALSE(std::filesystem::exists(folder / "x"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  PendingFile(folder / "x").commit("new");
  EXPECT_EQ(content_of(folder / "x"), "new");
}

TEST(PendingFile, KeepsTheFormerContentUntilItIsCommitted) {
  const TemporaryFolder folder;
  write_content(folder / "x", "old");
  { PendingFile file(folder / "x"); }
  EXPECT_EQ(content_of(folder / "x"), "old");
}

TEST(PendingFile, WritesToDevicesDirectlyAndReportsAFullDisk) {
  EXPECT_NO_THROW(PendingFile("/dev/null").commit("x"));
  EXPECT_THROW(PendingFile("/dev/full").commit("x"), InputOutputError);
}

TEST(ReplaceFile, LeavesAFileOfTheSameContentAlone) {
  const TemporaryFolder folder;
  replace_file(folder / "x", "same");
  const auto time = std::filesystem::last_write_time(folder / "x");
  replace_file(folder / "x", "same");
  EXPECT_EQ(std::filesystem::last_write_time(folder / "x"), time);
}

}  // namespace
}  // namespace autoref::runner
