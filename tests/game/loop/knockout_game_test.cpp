// Games with extra time and shoot-outs, and games with a stopping clock, in records and result
// rows.
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/results/columns.hpp"
#include "experiments/results/game_report.hpp"
#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

int events_in(const GameRecord& record, referee::Event event) {
  return record.events[static_cast<std::size_t>(event)];
}

// Two teams that never score.
GameRecord drawn_knockout() {
  GameConfiguration game = short_game(5, 3);
  game.a.strategy = game.b.strategy = "dummy";
  game.match.knockout = true;
  game.match.rules.extra_half_s = 4;
  return play(game);
}

TEST(KnockoutGame, WithoutAGoalEndsInADrawnShootout) {
  const GameRecord record = drawn_knockout();
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.end_reason, EndReason::kShootout);
  EXPECT_EQ(record.goals_by_half.size(), 4U);
  EXPECT_EQ(record.shootout, (std::array<int, 2>{0, 0}));
  EXPECT_EQ(events_in(record, referee::Event::kPenaltyKickFailed), 100);  // fifty kicks per team
}

TEST(KnockoutGame, ContinuesAShootoutUntilOneSideHasWon) {
  GameConfiguration game = short_game(5, 1);
  game.match.knockout = true;
  game.match.rules.extra_half_s = 5;
  const GameRecord record = play(game);
  ASSERT_EQ(record.status, Status::kOk) << record.void_reason;
  ASSERT_EQ(record.end_reason, EndReason::kShootout);
  ASSERT_TRUE(record.shootout.has_value());
  EXPECT_NE((*record.shootout)[0], (*record.shootout)[1]);
  EXPECT_EQ(record.goals_a, record.goals_b);
}

TEST(KnockoutGame, IsOffByDefault) {
  GameConfiguration game = short_game(5, 3);
  game.a.strategy = game.b.strategy = "dummy";
  const GameRecord record = play(game);
  EXPECT_EQ(record.end_reason, EndReason::kTime);
  EXPECT_FALSE(record.shootout.has_value());
}

TEST(GameByTheClockOf2026, PlaysItsHalvesInFullAndEndsByItself) {
  const GameRecord record = play(short_game_by("2026-b", 20, 4));
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.end_reason, EndReason::kTime);
  EXPECT_GT(record.sim_s, 45);  // two halves with 20 s of play each, plus the stops
}

TEST(ShootoutInRows, HasItsOwnColumns) {
  experiments::GameRow row;
  const auto cell = [&row](const std::string& name) {
    const std::vector<experiments::Column> columns =
        experiments::outcome_columns(experiments::RowKind::kPlayed);
    const auto is_named = [&name](const experiments::Column& column) {
      return column.name == name;
    };
    return std::find_if(columns.begin(), columns.end(), is_named)->text(row);
  };
  EXPECT_EQ(cell("shootout_a"), "");
  row.record.shootout = {4, 2};
  row.record.end_reason = EndReason::kShootout;
  EXPECT_EQ(cell("shootout_a"), "4");
  EXPECT_EQ(cell("shootout_b"), "2");
  EXPECT_EQ(cell("end_reason"), "shootout");
}

TEST(ShootoutInReports, AppearsInTextAndJson) {
  const GameConfiguration game;
  GameRecord record;
  record.goals_by_half = {{1, 1}};
  EXPECT_NE(experiments::json_of({game, record, 2.0, "x"}).find(R"("shootout": null)"),
            std::string::npos);
  record.shootout = {4, 2};
  EXPECT_NE(experiments::text_of({game, record, 2.0, "x"}).find("halves 1:1   shoot-out 4:2"),
            std::string::npos);
  EXPECT_NE(experiments::json_of({game, record, 2.0, "x"}).find(R"("shootout": [4, 2])"),
            std::string::npos);
}

}  // namespace
}  // namespace autoref::game
