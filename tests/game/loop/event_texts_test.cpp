// The wording of an event log's sentences.
#include <gtest/gtest.h>
#include <regex.h>

#include "tests/support/event_lines.hpp"

namespace autoref::game {
namespace {

// Whether the POSIX extended regular expression matches somewhere in the text.
bool has_match(const std::string& text, const char* pattern) {
  regex_t compiled;
  if (regcomp(&compiled, pattern, REG_EXTENDED | REG_NOSUB) != 0) {
    ADD_FAILURE() << "invalid pattern " << pattern;
    return false;
  }
  const bool found = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
  regfree(&compiled);
  return found;
}

class EventTexts : public testing::TestWithParam<const char*> {
 protected:
  const PlayedEvents events_ = played_events(foul_game(GetParam(), 2, 240));
};

TEST_P(EventTexts, NameSidesOnlyByTheirColours) {
  ASSERT_GT(events_.lines.size(), 50U);
  for (YAML::Node line : events_.lines) {
    line.remove("yellow_defends");
    EXPECT_FALSE(has_match(YAML::Dump(line), R"(\b([Ww]est|[Ee]ast)\b)")) << line;
  }
  EXPECT_TRUE(has_match(events_.text, R"(\b([Yy]ellow|[Bb]lue) [0-9])"));
}

TEST_P(EventTexts, HaveNoNegativeDistances) {
  EXPECT_FALSE(has_match(events_.text, R"( -[0-9.]+ mm\b)")) << events_.text;
}

TEST_P(EventTexts, UseTheTermsGoalLineAndTouchLine) {
  EXPECT_EQ(events_.text.find("boundary"), std::string::npos);
  EXPECT_NE(events_.text.find("crossed a touch line"), std::string::npos);
}

TEST_P(EventTexts, BeginWithACapitalLetterAndEndWithAFullStop) {
  for (const YAML::Node& line : events_.lines) {
    if (line["evidence"].IsNull()) continue;
    const auto text = line["evidence"].as<std::string>();
    EXPECT_TRUE(has_match(text, R"(^[A-Z0-9].*\.$)")) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachBook, EventTexts, testing::Values("paper", "2014", "2026-b"),
                         [](const auto& book) {
                           std::string name = book.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// A line gives the reason for a card if and only if it has a card.
TEST(EventCards, HaveAReason) {
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

TEST(EventCards, NameTheFoulAndTheActiveCardThatCauseARedCard) {
  const PlayedEvents events = played_events(foul_game("2026-b", 3, 600));
  const auto yellow = events.of("multiple_fouls");
  const auto red = events.of("multiple_cards");
  ASSERT_FALSE(yellow.empty());
  ASSERT_FALSE(red.empty());
  EXPECT_EQ(yellow.front()["card_reason"].as<std::string>(), "3rd foul (every 3rd brings a card)");
  EXPECT_EQ(red.front()["card"].as<std::string>(), "red");
  const auto reason = red.front()["card_reason"].as<std::string>();
  EXPECT_TRUE(has_match(reason,
                        "^[0-9]+th foul \\(every 3rd brings a card\\); red because it would be the "
                        "3rd active yellow card$"))
      << reason;
}

}  // namespace
}  // namespace autoref::game
