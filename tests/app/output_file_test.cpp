#include "app/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "io/errors.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

TEST(LineOutput, KeepsFewLinesOfALongGame) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "events.jsonl";
  LineOutput output("--events", path.string());
  const std::string line(999, 'x');
  for (int i = 0; i < 10'000; ++i) {
    output.add(line);
    ASSERT_LE(output.waiting_bytes(), LineOutput::kMostWaiting_bytes);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  output.commit();
  EXPECT_EQ(std::filesystem::file_size(path), 10'000'000U);
}

TEST(LineOutput, HasAllLinesInTheirOrder) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "events.jsonl";
  LineOutput output("--events", path.string());
  std::string expected;
  for (int i = 0; i < 20'000; ++i) {
    output.add(std::to_string(i));
    expected += std::to_string(i) + "\n";
  }
  output.commit();
  EXPECT_EQ(io::read_file(path), expected);
}

TEST(LineOutput, APipeThatNobodyReadsDoesNotDelayTheGame) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = io::read_user_file(path); });
  {
    LineOutput output("--events", path.string());
    for (int i = 0; i < 1000; ++i) output.add(std::string(999, 'x'));
    EXPECT_EQ(output.waiting_bytes(), 1'000'000U);
    output.commit();
  }
  reader.join();
  EXPECT_EQ(read.size(), 1'000'000U);
}

TEST(LineOutput, LinesAppearAtOnceIfAskedTo) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "events.jsonl";
  write_content(path, "of another game");
  LineOutput output("--events", path.string(), Appears::kAtOnce);
  output.add("head");
  EXPECT_EQ(content_of(path), "of another game");
  output.begin();
  EXPECT_EQ(content_of(path), "head\n");
  output.add("one");
  output.begin();
  EXPECT_EQ(content_of(path), "head\none\n");
  output.commit();
  EXPECT_EQ(content_of(path), "head\none\n");
}

TEST(LineOutput, LinesWaitWhileAPipeIsFull) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  LineOutput output("--events", path.string(), Appears::kAtOnce);
  output.begin();
  output.add("one");
  EXPECT_EQ(output.waiting_bytes(), 0U);
  for (int i = 0; i < 1000; ++i) output.add(std::string(999, 'x'));  // more than a pipe holds
  EXPECT_GT(output.waiting_bytes(), 0U);
  EXPECT_LT(output.waiting_bytes(), 1'000'000U);
  close(reader);
}

TEST(LineOutput, GoesOnWithoutAReaderThatIsGone) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  LineOutput output("--events", path.string(), Appears::kAtOnce);
  output.begin();
  close(reader);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) output.add("nowhere");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "autoref: " + path.string() + " cannot be written: Broken pipe\n");
  EXPECT_EQ(output.waiting_bytes(), 0U);
  EXPECT_THROW(output.commit(), io::InputOutputError);
}

TEST(LineOutput, WithoutAPathNothingIsOpened) {
  LineOutput output("--events", "");
  EXPECT_FALSE(output.is_open());
  output.add("nowhere");
  EXPECT_EQ(output.waiting_bytes(), 0U);
  output.commit();
}

}  // namespace
}  // namespace autoref::app
