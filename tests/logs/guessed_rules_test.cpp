#include "logs/log_game.hpp"

#include <gtest/gtest.h>

#include "soccer/rules/rule_book.hpp"

namespace autoref::logs {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kJuly2014_ns = 1'405'900'800 * kSecond_ns;  // 21 July
constexpr std::int64_t kJuly2017_ns = 1'501'200'000 * kSecond_ns;
constexpr std::int64_t kJuly2026_ns = 1'783'000'000 * kSecond_ns;

league::LogSummary log_of(const std::string& book, std::int64_t first_ns) {
  league::LogSummary log;
  log.field = find_game_setup(book)->field;
  log.first_ns = first_ns;
  return log;
}

TEST(GuessedRules, FitTheFieldAndTheDate) {
  EXPECT_EQ(guessed_rules(log_of("2014", kJuly2014_ns)).book, "2014");
  EXPECT_EQ(guessed_rules(log_of("2014-double", kJuly2014_ns)).book, "2014-double");
  EXPECT_EQ(guessed_rules(log_of("2026-a", kJuly2026_ns)).book, "2026-a");
  EXPECT_EQ(guessed_rules(log_of("2026-b", kJuly2026_ns)).book, "2026-b");
}

// Times of this program's logs count from 0.
TEST(GuessedRules, OfLogsWithoutADateFitTheField) {
  for (const char* book : {"paper", "2014-double", "2026-a", "2026-b"})
    EXPECT_EQ(guessed_rules(log_of(book, 0)).book, book);
  EXPECT_EQ(guessed_rules(log_of("paper", -5)).book, "paper");
}

// The field of 9 m had quarter circles until 2017.
TEST(GuessedRules, ConsiderTheShapeOfTheAreas) {
  league::LogSummary log = log_of("2026-b", kJuly2017_ns);
  log.field->defence_area.shape = DefenceArea::Shape::kQuarterCircles;
  EXPECT_EQ(guessed_rules(log).book, "2014-double");
  log.field_gaps.defence_area = true;  // the shape is a default
  EXPECT_EQ(guessed_rules(log).book, "2014-double");
  log.first_ns = kJuly2026_ns;
  EXPECT_EQ(guessed_rules(log).book, "2026-b");
}

TEST(GuessedRules, SayWhatTheyAreGuessedFrom) {
  EXPECT_EQ(guessed_rules(log_of("2014", kJuly2014_ns)).reason,
            "a field of 6.05 x 4.05 m, recorded on 2014-07-21");
  EXPECT_EQ(guessed_rules({}).reason, "an unknown field, without a date");
}

}  // namespace
}  // namespace autoref::logs
