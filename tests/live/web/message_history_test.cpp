#include "live/web/live_page.hpp"

#include <gtest/gtest.h>

namespace autoref::live {
namespace {

std::string joined(const MessageList& list) {
  std::vector<WebText> texts;
  list.append_to(texts);
  std::string all;
  for (const WebText& text : texts) all.append(*text).append(1, ' ');
  return all;
}

TEST(MessageList, KeepsTheNewestMessagesWithEnoughEntries) {
  MessageList list(10);
  for (const char* text : {"a", "b", "c", "d"}) list.add({text, 4});
  EXPECT_EQ(joined(list), "b c d ");
  EXPECT_EQ(list.entries(), 12U);
}

TEST(MessageList, IsLimitedHoweverLongTheGameIs) {
  MessageList list(100);
  for (int i = 0; i < 100'000; ++i) {
    list.add({"x", 3});
    ASSERT_LT(list.entries(), 103U);
  }
  EXPECT_GE(list.entries(), 100U);
}

TEST(MessageList, KeepsTheNewestMessageHoweverLongItIs) {
  MessageList list(10);
  list.add({"a", 4});
  list.add({"b", 1000});
  EXPECT_EQ(joined(list), "b ");
}

TEST(MessageList, LeavesOutMessagesWithoutEntries) {
  MessageList list(10);
  list.add({"a", 1});
  list.add({"b", 0});
  EXPECT_EQ(joined(list), "a ");
}

TEST(MessageHistory, ReplacesMessagesByThoseOfItsLists) {
  MessageHistory history("start", {10, 10});
  history.add("one", true);
  history.add("two", false);
  history.fold({{"calls", 1}, {"frames", 2}});
  history.add("three", true);
  std::string all;
  for (const WebText& text : history.backlog().texts) all.append(*text).append(1, ' ');
  EXPECT_EQ(all, "start calls frames three ");
  EXPECT_EQ(history.backlog().last_number, 3);
}

}  // namespace
}  // namespace autoref::live
