#include "io/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

#include "io/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/time_limit.hpp"

namespace autoref::io {
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
  EXPECT_NO_THROW(PendingFile("/dev/null", FileKind::kFileOrPipe).commit("x"));
  EXPECT_THROW(PendingFile("/dev/full", FileKind::kFileOrPipe).commit("x"), InputOutputError);
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
  EXPECT_THROW(PendingFile(folder / "x", FileKind::kFile, 0.02), InputOutputError);
  first.commit("first");
  PendingFile(folder / "x", FileKind::kFile, 0.02).commit("second");
  EXPECT_EQ(content_of(folder / "x"), "second");
}

std::string message_of_failure(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputOutputError& error) {
    return error.what();
  }
  return "succeeded";
}

TEST(OwnFile, IsNotReadFromAPipeThatHasItsName) {
  const TimeLimit limit;
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "x").c_str(), 0600), 0);
  const std::string expected =
      (folder / "x").string() + " is a FIFO where a file is expected; remove it";
  EXPECT_EQ(message_of_failure([&folder] { read_file(folder / "x"); }), expected);
  EXPECT_EQ(message_of_failure([&folder] { replace_file(folder / "x", "new"); }), expected);
}

TEST(OwnFile, IsNotReadThroughALinkToAPipeOrADevice) {
  const TimeLimit limit;
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink(folder / "pipe", folder / "x");
  std::filesystem::create_symlink("/dev/zero", folder / "y");
  EXPECT_TRUE(message_of_failure([&folder] {
                read_file(folder / "x");
              }).ends_with("x is a FIFO where a file is expected; remove it"));
  EXPECT_TRUE(message_of_failure([&folder] {
                read_file(folder / "y");
              }).ends_with("y is a device where a file is expected; remove it"));
}

TEST(OwnFile, IsReadThroughALinkToAFile) {
  const TemporaryFolder folder;
  write_content(folder / "x", "text");
  std::filesystem::create_symlink(folder / "x", folder / "link");
  EXPECT_EQ(read_file(folder / "link"), "text");
}

TEST(PendingFile, ThatGrowsAppearsAsItIsWritten) {
  const TemporaryFolder folder;
  write_content(folder / "x", "of another game");
  {
    PendingFile file(folder / "x", FileKind::kGrowing);
    EXPECT_EQ(content_of(folder / "x"), "of another game");
    file.begin();
    EXPECT_EQ(content_of(folder / "x"), "");
    file.write("one ");
    file.write("two");
    EXPECT_EQ(content_of(folder / "x"), "one two");
    for (const FileKind kind : {FileKind::kGrowing, FileKind::kFileOrPipe})
      EXPECT_THROW(PendingFile(folder / "x", kind, 0.02), InputOutputError);
  }
  EXPECT_EQ(content_of(folder / "x"), "one two");
  EXPECT_FALSE(std::filesystem::exists(folder / "x.part"));
}

TEST(PendingFile, ThatGrowsButNeverBeginsChangesNothing) {
  const TemporaryFolder folder;
  write_content(folder / "x", "old");
  std::filesystem::create_symlink("nothing", folder / "link");
  for (const char* name : {"x", "y", "link"}) PendingFile(folder / name, FileKind::kGrowing);
  EXPECT_FALSE(std::filesystem::exists(folder / "nothing"));
  EXPECT_EQ(content_of(folder / "x"), "old");
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder / "y")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
}

TEST(PendingFile, IsNotWrittenToWhatHasTheNameOfItsTemporaryFile) {
  const TimeLimit limit;
  const TemporaryFolder folder;
  write_content(folder / "other", "kept");
  std::filesystem::create_symlink(folder / "other", folder / "x.part");
  ASSERT_EQ(mkfifo((folder / "y.part").c_str(), 0600), 0);
  EXPECT_TRUE(message_of_failure([&folder] {
                PendingFile file(folder / "x");
              }).ends_with("x.part is a symbolic link where a file is expected; remove it"));
  EXPECT_TRUE(message_of_failure([&folder] {
                PendingFile file(folder / "y");
              }).ends_with("y.part is a FIFO where a file is expected; remove it"));
  EXPECT_EQ(content_of(folder / "other"), "kept");
}

TEST(PendingFile, ReplacesAPipeThatHasTheNameOfAnOwnFile) {
  const TimeLimit limit;
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "x").c_str(), 0600), 0);
  PendingFile(folder / "x").commit("new");
  EXPECT_EQ(content_of(folder / "x"), "new");
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
}  // namespace autoref::io
