#include "app/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <utility>

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

// Lines that appear at once in a pipe.
class LinesInAPipe : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
    reader_ = open(path_.c_str(), O_RDONLY | O_NONBLOCK);
    output_.emplace("--events", path_.string(), Appears::kAtOnce);
    output_->begin();
  }
  void TearDown() override { close_reader(); }

  void close_reader() {
    if (reader_ >= 0) close(std::exchange(reader_, -1));
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "pipe";
  int reader_ = -1;
  std::optional<LineOutput> output_;
};

TEST_F(LinesInAPipe, WaitWhileItIsFull) {
  output_->add("one");
  EXPECT_EQ(output_->waiting_bytes(), 0U);
  for (int i = 0; i < 1000; ++i) output_->add(std::string(999, 'x'));  // more than a pipe holds
  EXPECT_GT(output_->waiting_bytes(), 0U);
  EXPECT_LT(output_->waiting_bytes(), 1'000'000U);
}

TEST_F(LinesInAPipe, AreGivenUpIfItsReaderIsGone) {
  close_reader();
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) output_->add("nowhere");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "autoref: " + path_.string() + " cannot be written: Broken pipe\n");
  EXPECT_EQ(output_->waiting_bytes(), 0U);
  EXPECT_THROW(output_->commit(), io::InputOutputError);
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
