#include "io/processes/standings_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace autoref::io {
namespace {

TEST(BarText, IsFullWhenEverythingIsDone) {
  EXPECT_EQ(bar_text(0, 4), "[........................] ");
  EXPECT_EQ(bar_text(1, 4), "[######..................] ");
  EXPECT_EQ(bar_text(4, 4), "[########################] ");
}

TEST(StandingsTable, IsOnlyABarWithoutATable) {
  EXPECT_EQ(standings_table("the bar", "", {24, 80}), "\r\033[Jthe bar");
}

TEST(StandingsTable, LeavesTheCursorInTheBarsLine) {
  EXPECT_EQ(standings_table("the bar", "one\n\nthree\n", {24, 80}),
            "\r\033[Jthe bar\none\n\nthree\r\033[3A");
}

TEST(StandingsTable, FitsTheScreensHeight) {
  const std::string view = standings_table("the bar", "1\n2\n3\n4\n5\n6\n", {6, 80});
  EXPECT_EQ(view, "\r\033[Jthe bar\n1\n2\n3\n... 3 more lines\r\033[4A");
}

TEST(StandingsTable, FitsTheScreensWidth) {
  EXPECT_EQ(standings_table("0123456789", "±±±±±±±±±±\n", {24, 6}),
            "\r\033[J01234\n±±±±±\r\033[1A");
}

TEST(StandingsTable, FitsTheSmallestScreen) {
  EXPECT_EQ(standings_table("the bar", "1\n2\n", {1, 4}), "\r\033[Jthe");
}

TEST(StandingsTable, EndsInTheLineBelowIfItStays) {
  EXPECT_EQ(last_standings_table("the bar", "one\n", {24, 80}), "\r\033[Jthe bar\none\n");
}

TEST(BarLine, GetsShorterIfSpaceIsShort) {
  EXPECT_EQ(bar_line(1, 2, "1/2 games", 80), "[############............] 1/2 games");
  EXPECT_EQ(bar_line(1, 2, "1/2 games", 23), "[#####.....] 1/2 games");
  EXPECT_EQ(bar_line(1, 2, "1/2 games", 16), "1/2 games");
}

// A table of `teams` teams, the best first.
ProgressTable standings_of(int teams) {
  ProgressTable table{{{"", "team", "points", "games", "rating"}}, {}, "teams", {4, 3}};
  for (int i = 1; i <= teams; ++i) {
    table.rows.push_back({std::to_string(i), "team" + std::to_string(i), "30", "12", "+0.50"});
  }
  return table;
}

int lines_in(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(FittedTables, ShowTheBestTeamsAndTheNumberOfOthers) {
  const std::string text = fitted({standings_of(40)}, 6, 80);
  EXPECT_EQ(lines_in(text), 6);
  EXPECT_NE(text.find("4    team4"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n... 36 more teams\n")) << text;
}

TEST(FittedTables, ShowTheStandingsBeforeTheMatchups) {
  ProgressTable matchups{{{"a", "b"}}, {}, "matchups"};
  for (int i = 0; i < 100; ++i) matchups.rows.push_back({"x", "y"});
  const std::string text = fitted({standings_of(4), matchups}, 10, 80);
  EXPECT_EQ(lines_in(text), 10);
  EXPECT_NE(text.find("\n4   team4"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n\na   b\nx   y\nx   y\n... 98 more matchups\n")) << text;
}

TEST(FittedTables, DropTheDispensableColumnsFirst) {
  EXPECT_TRUE(
      fitted({standings_of(3)}, 20, 80).starts_with("     team   points   games   rating\n"));
  EXPECT_TRUE(fitted({standings_of(3)}, 20, 30).starts_with("     team   points   games\n"));
  EXPECT_TRUE(fitted({standings_of(3)}, 20, 24).starts_with("     team   points\n"));
  EXPECT_TRUE(fitted({standings_of(3)}, 20, 12).starts_with("     team\n"));
}

TEST(FittedTables, BreakLongLinesBetweenWords) {
  ProgressTable table{{{"a"}, {"1"}}};
  table.text = "not yet decided\nafter 12 pairs\n";
  EXPECT_EQ(fitted({table}, 20, 12), "a\n1\n\nnot yet\ndecided\nafter 12\npairs\n");
}

TEST(FittedTables, NeverHaveMoreLinesThanTheScreen) {
  ProgressTable with_text = standings_of(8);
  with_text.text = "one\ntwo\n";
  for (int lines = -2; lines < 30; ++lines) {
    EXPECT_LE(lines_in(fitted({with_text, standings_of(8)}, lines, 60)), std::max(0, lines));
  }
}

}  // namespace
}  // namespace autoref::io
