#include "experiments/run/completed_games.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "experiments/kinds/sweep/sweep.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {
namespace {

const RowFormat kFakeFormat({"b.robots"});

std::vector<ScheduledGame> fake_schedule() { return small_sweep().as<Sweep>()->games(); }

GameRow rows_played(const ScheduledGame& game, const game::GameRecord& record,
                    const std::string& build) {
  GameRow row = row_of(game);
  row.record = record;
  row.circumstances.build = build;
  row.circumstances.wall_s = 1;
  return row;
}

GameRow rows_played(const ScheduledGame& game, const std::string& build = "x") {
  return rows_played(game, fake_game(game::resolved(game.settings.combined())), build);
}

CompletedGames completed_games_of(const std::vector<GameRow>& in_files,
                                  bool allow_mixed_build = false) {
  RowsInFiles rows;
  for (const GameRow& row : in_files) rows.emplace(row.game_id, row);
  return sort_rows(rows, fake_schedule(), kFakeFormat, "x", allow_mixed_build, "DIR", "");
}

TEST(CompletedGames, ContainsScheduledGames) {
  const std::vector<ScheduledGame> games = fake_schedule();
  const CompletedGames completed_games =
      completed_games_of({rows_played(games[0]), rows_played(games[5])});
  EXPECT_EQ(completed_games.done.size(), 2U);
  EXPECT_TRUE(completed_games.done.contains(games[5].id));
}

TEST(CompletedGames, CountsDuplicateRowsOnce) {
  const ScheduledGame game = fake_schedule()[0];
  EXPECT_EQ(completed_games_of({rows_played(game), rows_played(game)}).done.size(), 1U);
}

TEST(CompletedGames, ReportsNondeterminismIfTwoRowsOfOneGameDiffer) {
  const ScheduledGame game = fake_schedule()[0];
  game::GameRecord other = fake_game(game::resolved(game.settings.combined()));
  ++other.state_hash;
  try {
    completed_games_of({rows_played(game), rows_played(game, other, "x")});
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("nondeterminism: game " + game.id));
    EXPECT_NE(std::string(error.what()).find("state_hash"), std::string::npos);
  }
}

TEST(CompletedGames, PrefersTheOtherRowToThatOfAKilledGame) {
  const ScheduledGame game = fake_schedule()[0];
  game::GameRecord killed;
  killed.status = game::Status::kVoid;
  killed.void_reason = "its process was ended by signal 9 (Killed), in attempt 3";
  const GameRow good = rows_played(game);
  const GameRow gone = rows_played(game, killed, "x");
  for (const auto& rows :
       {std::vector{gone, good}, std::vector{good, gone}, std::vector{gone, good, gone, good}}) {
    const GameRow kept = completed_games_of(rows).done.at(game.id);
    EXPECT_FALSE(kFakeFormat.first_difference(kept, good)) << kFakeFormat.line(kept);
  }
}

TEST(CompletedGames, RefusesRowsOfAnotherBuild) {
  EXPECT_THROW(completed_games_of({rows_played(fake_schedule()[0], "y")}), io::InputError);
}

TEST(CompletedGames, CountsAllowedRowsOfAnotherBuildSeparately) {
  const ScheduledGame game = fake_schedule()[0];
  const CompletedGames completed_games = completed_games_of({rows_played(game, "y")}, true);
  EXPECT_TRUE(completed_games.done.empty());
  EXPECT_EQ(completed_games.other_builds.at("y"), 1);
}

TEST(CompletedGames, RefusesAGameOfAnotherConfiguration) {
  ScheduledGame game = fake_schedule()[0];
  game::GameSettings longer = game.settings.combined();
  longer.match.half_s = 60;
  game.settings = SharedSettings(longer);
  EXPECT_THROW(completed_games_of({rows_played(game)}), io::InputError);
}

TEST(CompletedGames, CountsUnscheduledGamesSeparately) {
  ScheduledGame game = fake_schedule()[0];
  game.id = "b.robots=1-p0001-1";
  const CompletedGames completed_games = completed_games_of({rows_played(game)});
  EXPECT_TRUE(completed_games.done.empty());
  EXPECT_EQ(completed_games.other_games, 1);
}

}  // namespace
}  // namespace autoref::experiments
