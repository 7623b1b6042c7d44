// What the sentences of an event log say, and in which words.
#include <gtest/gtest.h>

#include <regex>

#include "tests/runner/support/event_lines.hpp"

namespace autoref::runner {
namespace {

class EventTexts : public testing::TestWithParam<const char*> {
 protected:
  const PlayedEvents events_ = played_events(foul_game(GetParam(), 2, 120));
};

TEST_P(EventTexts, NameSidesByTheirColoursOnly) {
  ASSERT_GT(events_.lines.size(), 50U);
  EXPECT_FALSE(std::regex_search(events_.text, std::regex(R"(\b([Ww]est|[Ee]ast)\b)")));
  EXPECT_TRUE(std::regex_search(events_.text, std::regex(R"(\b([Yy]ellow|[Bb]lue) \d)")));
}

TEST_P(EventTexts, HaveNoNegativeDistances) {
  EXPECT_FALSE(std::regex_search(events_.text, std::regex(R"( -[\d.]+ mm\b)"))) << events_.text;
}

TEST_P(EventTexts, SayGoalLineAndTouchLine) {
  EXPECT_EQ(events_.text.find("boundary"), std::string::npos);
  EXPECT_NE(events_.text.find("crossed a touch line"), std::string::npos);
}

TEST_P(EventTexts, BeginWithACapitalLetterAndEndWithAFullStop) {
  for (const YAML::Node& line : events_.lines) {
    if (line["evidence"].IsNull()) continue;
    const auto text = line["evidence"].as<std::string>();
    EXPECT_TRUE(std::regex_match(text, std::regex("[A-Z0-9].*\\."))) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachBook, EventTexts, testing::Values("paper", "2014", "2026-b"),
                         [](const auto& book) {
                           std::string name = book.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Every card comes with the reason for it, and nothing else does.
TEST(EventCards, SayWhyTheyAreShown) {
  int cards = 0;
  for (const char* book : {"2014", "2026-b"}) {
    const PlayedEvents events = played_events(foul_game(book, 2, 300));
    for (const YAML::Node& line : events.lines) {
      EXPECT_EQ(line["card"].IsNull(), line["card_reason"].IsNull());
      if (!line["card"].IsNull()) ++cards;
    }
  }
  EXPECT_GT(cards, 5);
}

TEST(EventCards, SayWhichFoulAndWhichActiveCardMakesOneRed) {
  const PlayedEvents events = played_events(foul_game("2026-b", 2, 120));
  const auto yellow = events.of("multiple_fouls");
  const auto red = events.of("multiple_cards");
  ASSERT_FALSE(yellow.empty());
  ASSERT_FALSE(red.empty());
  EXPECT_EQ(yellow.front()["card_reason"].as<std::string>(),
            "3rd foul, and every 3rd gives a card");
  EXPECT_EQ(red.front()["card"].as<std::string>(), "red");
  EXPECT_EQ(red.front()["card_reason"].as<std::string>(),
            "9th foul, and every 3rd gives a card; red because it is the 3rd active yellow card");
}

}  // namespace
}  // namespace autoref::runner
