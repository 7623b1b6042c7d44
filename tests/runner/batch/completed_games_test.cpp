#include "runner/batch/completed_games.hpp"

#include <gtest/gtest.h>

#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "tests/runner/batch/fake_games.hpp"

namespace autoref::runner {
namespace {

const RowFormat kFormat({"b.robots"});

std::vector<ScheduledGame> scheduled_games() {
  return scheduled_games(std::get<Sweep>(small_sweep().content));
}

StoredRow row_of(const ScheduledGame& game, const GameRecord& record, const std::string& build) {
  const Cells cells =
      kFormat.read(kFormat.line(game, outcome_of(record), {build, "host", "cpu", 1.0, 1, "0/1"}))
          .value();
  return {game.id, build, cells[kFormat.column("config_hash")], cells};
}

StoredRow row_of(const ScheduledGame& game, const std::string& build = "x") {
  return row_of(game, fake_game(game.configuration), build);
}

CompletedGames completed_games_of(const std::vector<StoredRow>& rows,
                                  bool allow_mixed_build = false) {
  return sort_rows(rows, scheduled_games(), kFormat, "x", allow_mixed_build, "DIR", "");
}

TEST(CompletedGames, HoldsTheGamesOfThePlan) {
  const std::vector<ScheduledGame> games = scheduled_games();
  const CompletedGames completed_games = completed_games_of({row_of(games[0]), row_of(games[5])});
  EXPECT_EQ(completed_games.done.size(), 2U);
  EXPECT_TRUE(completed_games.done.contains(games[5].id));
}

TEST(CompletedGames, TakesTheSameRowTwiceForOne) {
  const ScheduledGame game = scheduled_games()[0];
  EXPECT_EQ(completed_games_of({row_of(game), row_of(game)}).done.size(), 1U);
}

TEST(CompletedGames, CallsTwoDifferentRowsOfOneGameNondeterminism) {
  const ScheduledGame game = scheduled_games()[0];
  GameRecord other = fake_game(game.configuration);
  ++other.state_hash;
  try {
    completed_games_of({row_of(game), row_of(game, other, "x")});
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("nondeterminism: the game " + game.id));
    EXPECT_NE(std::string(error.what()).find("state_hash"), std::string::npos);
  }
}

TEST(CompletedGames, LetsARowOfAKilledGameGiveWayToTheOther) {
  const ScheduledGame game = scheduled_games()[0];
  GameRecord killed;
  killed.status = Status::kVoid;
  killed.void_reason = "its process was ended by signal 9 (Killed), in attempt 3";
  const StoredRow good = row_of(game);
  const StoredRow gone = row_of(game, killed, "x");
  for (const auto& rows :
       {std::vector{gone, good}, std::vector{good, gone}, std::vector{gone, good, gone, good}}) {
    EXPECT_EQ(completed_games_of(rows).done.at(game.id), good.cells);
  }
}

TEST(CompletedGames, RefusesRowsOfAnotherBuild) {
  EXPECT_THROW(completed_games_of({row_of(scheduled_games()[0], "y")}), InputError);
}

TEST(CompletedGames, KeepsAllowedRowsOfAnotherBuildApart) {
  const ScheduledGame game = scheduled_games()[0];
  const CompletedGames completed_games = completed_games_of({row_of(game, "y")}, true);
  EXPECT_TRUE(completed_games.done.empty());
  EXPECT_EQ(completed_games.other_builds.at("y"), 1);
}

TEST(CompletedGames, RefusesAGameOfAnotherConfiguration) {
  ScheduledGame game = scheduled_games()[0];
  game.configuration.match.half_s = 60;
  EXPECT_THROW(completed_games_of({row_of(game)}), InputError);
}

TEST(CompletedGames, CountsGamesThatThePlanDoesNotHave) {
  ScheduledGame game = scheduled_games()[0];
  game.id = "b.robots=1-p0001-1";
  const CompletedGames completed_games = completed_games_of({row_of(game)});
  EXPECT_TRUE(completed_games.done.empty());
  EXPECT_EQ(completed_games.other_games, 1);
}

}  // namespace
}  // namespace autoref::runner
