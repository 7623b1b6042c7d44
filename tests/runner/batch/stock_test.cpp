#include "runner/batch/stock.hpp"

#include <gtest/gtest.h>

#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "tests/runner/batch/fake_games.hpp"

namespace autoref::runner {
namespace {

const RowFormat kFormat({"b.robots"});

std::vector<PlannedGame> planned_games() { return plan(std::get<Sweep>(small_sweep().content)); }

StoredRow row_of(const PlannedGame& game, const GameRecord& record, const std::string& build) {
  const Cells cells =
      kFormat.read(kFormat.line(game, outcome_of(record), {build, "host", "cpu", 1.0, 1, "0/1"}))
          .value();
  return {game.id, build, cells[kFormat.column("config_hash")], cells};
}

StoredRow row_of(const PlannedGame& game, const std::string& build = "x") {
  return row_of(game, fake_game(game.configuration), build);
}

Stock stock_of(const std::vector<StoredRow>& rows, bool allow_mixed_build = false) {
  return take_stock(rows, planned_games(), kFormat, "x", allow_mixed_build, "DIR", "");
}

TEST(Stock, HoldsTheGamesOfThePlan) {
  const std::vector<PlannedGame> games = planned_games();
  const Stock stock = stock_of({row_of(games[0]), row_of(games[5])});
  EXPECT_EQ(stock.done.size(), 2U);
  EXPECT_TRUE(stock.done.contains(games[5].id));
}

TEST(Stock, TakesTheSameRowTwiceForOne) {
  const PlannedGame game = planned_games()[0];
  EXPECT_EQ(stock_of({row_of(game), row_of(game)}).done.size(), 1U);
}

TEST(Stock, CallsTwoDifferentRowsOfOneGameNondeterminism) {
  const PlannedGame game = planned_games()[0];
  GameRecord other = fake_game(game.configuration);
  ++other.state_hash;
  try {
    stock_of({row_of(game), row_of(game, other, "x")});
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("nondeterminism: the game " + game.id));
    EXPECT_NE(std::string(error.what()).find("state_hash"), std::string::npos);
  }
}

TEST(Stock, RefusesRowsOfAnotherBuild) {
  EXPECT_THROW(stock_of({row_of(planned_games()[0], "y")}), InputError);
}

TEST(Stock, KeepsAllowedRowsOfAnotherBuildApart) {
  const PlannedGame game = planned_games()[0];
  const Stock stock = stock_of({row_of(game, "y")}, true);
  EXPECT_TRUE(stock.done.empty());
  EXPECT_EQ(stock.other_builds.at("y"), 1);
}

TEST(Stock, RefusesAGameOfAnotherConfiguration) {
  PlannedGame game = planned_games()[0];
  game.configuration.match.half_s = 60;
  EXPECT_THROW(stock_of({row_of(game)}), InputError);
}

TEST(Stock, CountsGamesThatThePlanDoesNotHave) {
  PlannedGame game = planned_games()[0];
  game.id = "b.robots=1-p0001-1";
  const Stock stock = stock_of({row_of(game)});
  EXPECT_TRUE(stock.done.empty());
  EXPECT_EQ(stock.other_games, 1);
}

}  // namespace
}  // namespace autoref::runner
