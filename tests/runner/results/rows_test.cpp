#include "runner/results/rows.hpp"

#include <gtest/gtest.h>

#include "runner/io/csv.hpp"
#include "tests/runner/batch/fake_games.hpp"

namespace autoref::runner {
namespace {

std::string sample_line(const RowFormat& format, const std::string& void_reason = "") {
  const ScheduledGame game = scheduled_games(std::get<Sweep>(small_sweep().content)).front();
  GameRecord record = fake_game(game.configuration);
  record.void_reason = void_reason;
  return format.line(game, outcome_of(record), {"build", "host", "A, \"fast\" CPU", 1.5, 2, "0/1"});
}

TEST(Csv, QuotesWhatNeedsQuotes) {
  const std::vector<std::string> cells = {"plain", "a,b", "say \"hi\"", ""};
  EXPECT_EQ(csv_line(cells), "plain,\"a,b\",\"say \"\"hi\"\"\",");
  EXPECT_EQ(csv_cells(csv_line(cells)), cells);
}

TEST(Csv, KeepsARowOnOneLine) { EXPECT_EQ(csv_line({"a\nb"}), "\"a b\""); }

TEST(Csv, RefusesQuotesThatDoNotMatch) {
  for (const char* line : {"\"a", "a\"b", "\"a\"b"}) EXPECT_FALSE(csv_cells(line)) << line;
}

TEST(RowFormat, HasTheColumnsOfAGameWithTheCheckLast) {
  const RowFormat format({"b.robots"});
  EXPECT_TRUE(
      csv_line(format.columns())
          .starts_with("game_id,pair,leg,b.robots,team_a,team_b,side_a,seed,goals_a,goals_b,"
                       "goal_diff,first_half_goals_a,first_half_goals_b,end_reason,status,"
                       "void_reason,calls_goal,"));
  EXPECT_TRUE(csv_line(format.columns())
                  .ends_with(",ball_in_play_s,sim_s,frames,state_hash,config_hash,build,host,cpu,"
                             "wall_s,attempt,shard,row_crc"));
}

TEST(RowFormat, HasTheFiguresOfBothTeamsInEveryRow) {
  const RowFormat format({"b.robots"});
  const ScheduledGame game = scheduled_games(std::get<Sweep>(small_sweep().content)).front();
  GameRecord record;
  record.counts[0] = {12, 7, 30, 21, 301.25, 3, 5};
  record.counts[1] = {8, 2, 25, 9, 200.5, 4, 6};
  const Cells cells = format.read(format.line(game, outcome_of(record), {})).value();
  const Cells names = {"shots",        "shots_on_goal", "passes_tried", "passes_completed",
                       "possession_s", "fouls",         "duels_won"};
  const Cells of_a = {"12", "7", "30", "21", "301.250", "3", "5"};
  const Cells of_b = {"8", "2", "25", "9", "200.500", "4", "6"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(cells[format.column(names[i] + "_a")], of_a[i]) << names[i];
    EXPECT_EQ(cells[format.column(names[i] + "_b")], of_b[i]) << names[i];
  }
  EXPECT_LT(format.column("duels_won_b"), format.reproducible(format.columns()).size());
}

TEST(RowFormat, ReadsBackWhatItWrote) {
  const RowFormat format({"b.robots"});
  const auto cells = format.read(sample_line(format, "team a threw: \"x\", then\nmore"));
  ASSERT_TRUE(cells);
  EXPECT_EQ((*cells)[format.column("b.robots")], "6");
  EXPECT_EQ((*cells)[format.column("side_a")], "west");
  EXPECT_EQ((*cells)[format.column("void_reason")], "team a threw: \"x\", then more");
  EXPECT_EQ((*cells)[format.column("cpu")], "A, \"fast\" CPU");
  EXPECT_EQ((*cells)[format.column("attempt")], "2");
}

TEST(RowFormat, HoldsTheTransitionsTakenInAnOrderOfTheirOwn) {
  const RowFormat format({"b.robots"});
  const ScheduledGame game = scheduled_games(std::get<Sweep>(small_sweep().content)).front();
  GameRecord record;
  record.transitions = {"start", "begin", "goal"};
  const Cells cells = format.read(format.line(game, outcome_of(record), {})).value();
  EXPECT_EQ(cells[format.column("transitions")], "begin+goal+start");
  EXPECT_LT(format.column("transitions"), format.reproducible(format.columns()).size());
}

TEST(TransitionsNeverUsed, AreThoseThatStandInNoRow) {
  const RowFormat format({});
  Cells row(format.columns().size());
  row[format.column("transitions")] = "begin+start_late+goal_kick";
  const std::vector<std::string> never = transitions_never_used(format, {row});
  const auto has = [&](const char* label) {
    return std::find(never.begin(), never.end(), label) != never.end();
  };
  for (const char* taken : {"begin", "start_late", "goal_kick"}) EXPECT_FALSE(has(taken)) << taken;
  // Parts of a label that was taken, and one outside the figure.
  for (const char* other : {"start", "goal", "half_over"}) EXPECT_TRUE(has(other)) << other;
}

TEST(RowFormat, NoticesEveryChangedLetter) {
  const RowFormat format({"b.robots"});
  const std::string line = sample_line(format);
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string changed = line;
    changed[i] = changed[i] == '1' ? '2' : '1';
    EXPECT_FALSE(format.read(changed)) << i;
  }
}

TEST(RowFormat, LeavesOutOfTheResultsWhatMayDiffer) {
  const RowFormat format({"b.robots"});
  EXPECT_EQ(format.reproducible(format.columns()).back(), "config_hash");
}

}  // namespace
}  // namespace autoref::runner
