#include "app/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <thread>

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

TEST(LineOutput, WithoutAPathNothingIsOpened) {
  LineOutput output("--events", "");
  EXPECT_FALSE(output.is_open());
  output.commit();
}

}  // namespace
}  // namespace autoref::app
