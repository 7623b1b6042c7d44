#include "app/show/rules_verb.hpp"

#include <gtest/gtest.h>

#include "soccer/rules/rule_book.hpp"

namespace autoref::app {
namespace {

std::string line_of(const std::string& text, const std::string& rule) {
  const std::size_t begin = text.find("\n" + rule + " ");
  return begin == std::string::npos ? ""
                                    : text.substr(begin + 1, text.find('\n', begin + 1) - begin);
}

// Laws 2014, law 12: "kicks the ball such that it exceeds 8 m/s".
TEST(RulesReport, ShowsSectionsAndThresholdsOfTheLaws) {
  const std::string line =
      line_of(io::text_of(rules_text(*find_rule_book("2014"))), "bot_kicked_ball_too_fast");
  EXPECT_NE(line.find("Laws 12"), std::string::npos) << line;
  EXPECT_NE(line.find("8 m/s"), std::string::npos) << line;
}

TEST(RulesReport, ListsTheRuleBooks) {
  for (const std::string& name : rule_book_names()) {
    EXPECT_NE(books_text().find("\n" + name + " "), std::string::npos);
    EXPECT_NE(books_json().find("{\"name\": \"" + name + "\", "), std::string::npos)
        << books_json();
  }
}

TEST(RulesReport, ShowsThresholdsOf2026) {
  const std::string text = io::text_of(rules_text(*find_rule_book("2026-b")));
  EXPECT_NE(line_of(text, "bot_kicked_ball_too_fast").find("6.5 m/s"), std::string::npos);
  EXPECT_NE(line_of(text, "bot_dribbled_ball_too_far").find("1 m "), std::string::npos);
}

TEST(RulesReport, ListsOnlyRulesInForceWithTheirSections) {
  const std::string text = io::text_of(rules_text(*find_rule_book("paper")));
  EXPECT_NE(line_of(text, "goal").find("paper 4.4"), std::string::npos);
  EXPECT_EQ(line_of(text, "bot_crash_unique"), "");
  EXPECT_NE(text.substr(text.find("Not in force")).find("bot_crash_unique"), std::string::npos);
}

TEST(RulesReport, ListsEveryBookWithItsField) {
  const std::string text = books_text();
  for (const std::string& name : rule_book_names()) {
    EXPECT_NE(text.find("\n" + name), std::string::npos) << name;
  }
  EXPECT_NE(text.find("12 x    9 m, 11 robots"), std::string::npos) << text;
}

}  // namespace
}  // namespace autoref::app
