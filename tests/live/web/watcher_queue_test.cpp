#include "live/web/watcher.hpp"

#include <gtest/gtest.h>

namespace autoref::live {
namespace {

WebMessage numbered(std::int64_t number, bool is_frame) {
  return {std::make_shared<const std::string>(std::to_string(number)), is_frame, number};
}

std::string all_of(WatcherQueue& queue) {
  std::string all;
  while (const WebText text = queue.pop()) all.append(*text).append(1, ' ');
  return all;
}

TEST(WatcherQueue, OfFramesOnlyTheNewestWait) {
  WatcherQueue queue;
  for (int i = 1; i <= 10; ++i) EXPECT_TRUE(queue.push(numbered(i, true)));
  EXPECT_EQ(all_of(queue), "8 9 10 ");
  EXPECT_EQ(queue.left_out(), 7);
}

TEST(WatcherQueue, OtherMessagesAreKeptInOrder) {
  WatcherQueue queue;
  for (int i = 1; i <= 10; ++i) EXPECT_TRUE(queue.push(numbered(i, i % 5 != 0)));
  EXPECT_EQ(all_of(queue), "5 7 8 9 10 ");
}

TEST(WatcherQueue, RefusesTooManyMessages) {
  WatcherQueue queue;
  for (std::size_t i = 1; i <= WatcherQueue::kMostOthers; ++i)
    ASSERT_TRUE(queue.push(numbered(static_cast<std::int64_t>(i), false)));
  EXPECT_FALSE(queue.push(numbered(99'999, false)));
  EXPECT_TRUE(queue.push(numbered(100'000, true)));
}

// A message of 1 MiB, of which four fit in.
WebMessage long_message(std::int64_t number, bool is_frame) {
  return {std::make_shared<const std::string>(kMostWaiting_bytes / 4, ' '), is_frame, number};
}

TEST(WatcherQueue, RefusesTooManyBytes) {
  WatcherQueue queue;
  for (int i = 1; i <= 4; ++i) ASSERT_TRUE(queue.push(long_message(i, false)));
  EXPECT_FALSE(queue.push(numbered(5, false)));
}

TEST(WatcherQueue, BytesThatWereTakenMakeRoom) {
  WatcherQueue queue;
  for (int i = 1; i <= 100; ++i) {
    ASSERT_TRUE(queue.push(long_message(i, false)));
    queue.pop();
  }
}

TEST(WatcherQueue, BytesOfFramesThatWereLeftOutDoNotCount) {
  WatcherQueue queue;
  for (int i = 1; i <= 100; ++i) ASSERT_TRUE(queue.push(long_message(i, true)));
  EXPECT_TRUE(queue.push(long_message(101, false)));
}

TEST(WatcherQueue, TheBacklogComesFirstAndIsNotRepeated) {
  WatcherQueue queue;
  WebBacklog backlog;
  backlog.texts = {numbered(1, true).text, numbered(2, false).text};
  backlog.last_number = 2;
  queue.begin_with(backlog);
  for (int i = 2; i <= 4; ++i) EXPECT_TRUE(queue.push(numbered(i, true)));
  EXPECT_EQ(all_of(queue), "1 2 3 4 ");
}

}  // namespace
}  // namespace autoref::live
