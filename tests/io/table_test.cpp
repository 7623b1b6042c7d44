#include "io/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace autoref::io {
namespace {

TEST(Table, AlignsCellsRightByDefault) {
  EXPECT_EQ(aligned({{"a", "x"}, {"bcd", "100"}}, {Align::kLeft}), "a       x\nbcd   100\n");
}

TEST(Table, CountsLettersNotBytes) { EXPECT_EQ(aligned({{"±"}, {"ab"}}), " ±\nab\n"); }

TEST(Table, LeavesNoSpaceAtTheEndsOfLines) {
  EXPECT_EQ(aligned({{"a", "b"}, {"c", "long"}}, {Align::kLeft, Align::kLeft}),
            "a   b\nc   long\n");
}

std::size_t widest_line_of(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, width_of(line));
  return widest;
}

// Two rows of a sweep, as in docs/experiments.md.
const TextTable kSweepTable = {
    {{"b.handicap", "games", "goals a", "goals b", "a minus b [95 %]", "from the first [95 %]",
      "p"},
     {"1.0", "12", "6.50 ± 2.65", "7.75 ± 3.22", "-1.25 [-5.35, +2.85]", "", ""},
     {"0.5", "12", "33.83 ± 6.58", "0.25 ± 0.45", "+33.58 [+31.58, +35.59]",
      "+34.83 [+30.30, +39.37]", "<0.001"}},
    {}};

TEST(TableText, LeavesATableThatFitsAsItIs) {
  EXPECT_EQ(table_text({{{"a", "x"}, {"bcd", "100"}}, {Align::kLeft}}, 80),
            "a       x\nbcd   100\n");
}

TEST(TableText, GetsNarrowerGapsFirst) {
  EXPECT_EQ(table_text({{{"a", "x"}, {"bcd", "100"}}, {Align::kLeft}}, 8), "a      x\nbcd  100\n");
}

TEST(TableText, BreaksCellsBetweenWordsButNotWithinAnInterval) {
  EXPECT_EQ(table_text({{{"", "a minus b [95 %]"}, {"0.5", "+1.25 [-5.35, +2.85]"}}, {}}, 19),
            "          a minus b\n"
            "             [95 %]\n"
            "0.5           +1.25\n"
            "     [-5.35, +2.85]\n");
}

TEST(TableText, FitsEveryWidthAndLosesNothing) {
  for (const std::size_t width : {120, 100, 80, 60, 40}) {
    const std::string text = table_text(kSweepTable, width);
    EXPECT_LE(widest_line_of(text), width) << text;
    for (const char* part :
         {"b.handicap", "0.5", "6.58", "[+31.58, +35.59]", "[+30.30, +39.37]", "<0.001"})
      EXPECT_NE(text.find(part), std::string::npos) << width << " " << part << "\n" << text;
  }
}

TEST(TableText, OfThousandsOfRowsKeepsItsWidth) {
  TextTable table;
  for (int i = 0; i < 3000; ++i) table.rows.push_back({"name", "two words", "two more words"});
  EXPECT_EQ(table_text(table, 20), aligned(table.rows));
}

TEST(TableText, ContinuesBelowWithTheKeysIfWordsDoNotFit) {
  const TextTable table = {
      {{"team", "first", "second", "third"}, {"zone", "11111", "222222", "33333"}}, {Align::kLeft}};
  EXPECT_EQ(table_text(table, 20),
            "team  first  second\nzone  11111  222222\n\nteam   third\nzone   33333\n");
}

TEST(TableText, BreaksWordsIfNothingElseHelps) {
  const TextTable table = {{{"team", "n"}, {"a_name_of_twenty_letters", "12345"}}, {Align::kLeft}};
  EXPECT_EQ(table_text(table, 20), "team               n\na_name_of_twe  12345\nnty_letters\n");
}

TEST(Wrapped, BreaksOnlyLongLinesAndOnlyBetweenWords) {
  EXPECT_EQ(wrapped("one two three\n  indented\n\nlongerthanthat x\n", 9),
            "one two\nthree\n  indented\n\nlongerthanthat\nx\n");
}

TEST(WithoutZeros, RemovesOnlyAColumnOfZeros) {
  EXPECT_EQ(without_zeros({{{"a", "void"}, {"1", "0"}}, {}}, 1).rows,
            (std::vector<std::vector<std::string>>{{"a"}, {"1"}}));
  EXPECT_EQ(without_zeros({{{"a", "void"}, {"1", "2"}}, {}}, 1).rows.front().size(), 2U);
}

}  // namespace
}  // namespace autoref::io
