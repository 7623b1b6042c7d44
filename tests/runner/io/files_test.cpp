#include "runner/io/files.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "runner/io/errors.hpp"
#include "tests/runner/support/temporary_folder.hpp"

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

TEST(PendingFile, OverwritesWhatAKilledProcessLeft) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    const PendingFile file(folder / "x");
    std::raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_FALSE(std::filesystem::is_empty(folder.path()));  // otherwise nothing was left behind
  PendingFile(folder / "x").commit("new");
  EXPECT_EQ(content_of(folder / "x"), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(PendingFile, IsRefusedWhileAnotherWritesIt) {
  const TemporaryFolder folder;
  PendingFile first(folder / "x");
  EXPECT_THROW(PendingFile(folder / "x", 0.02), InputOutputError);
  first.commit("first");
  PendingFile(folder / "x", 0.02).commit("second");
  EXPECT_EQ(content_of(folder / "x"), "second");
}

TEST(ReplaceFile, IsSafeInSeveralProcessesAtOnce) {
  const TemporaryFolder folder;
  const auto write_often = [&folder](char letter) {
    for (int i = 0; i < 100; ++i) replace_file(folder / "x", std::string(10000, letter));
  };
  const pid_t child = fork();
  if (child == 0) {
    write_often('a');
    _exit(0);
  }
  write_often('b');
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  const std::string text = content_of(folder / "x");
  EXPECT_EQ(text, std::string(10000, text.at(0)));
}

TEST(ReplaceFile, LeavesAFileWithTheSameContentAlone) {
  const TemporaryFolder folder;
  replace_file(folder / "x", "same");
  const auto time = std::filesystem::last_write_time(folder / "x");
  replace_file(folder / "x", "same");
  EXPECT_EQ(std::filesystem::last_write_time(folder / "x"), time);
}

}  // namespace
}  // namespace autoref::runner
