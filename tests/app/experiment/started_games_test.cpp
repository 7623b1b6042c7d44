// Pages of games that a run has started.
#include "app/experiment/shown_run.hpp"

#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "io/checksum.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::app {
namespace {

experiments::ScheduledGame short_scheduled_game(const std::string& id, std::uint64_t seed) {
  game::GameSettings game;
  game.match.half_s = 2;
  game.seed = seed;
  return {id, {}, 1, 1, experiments::SharedSettings(game)};
}

TEST(StartedGames, HaveAPageOfTheSameGame) {
  StartedGames games;
  const experiments::ScheduledGame game = short_scheduled_game("p0001-1", 7);
  ASSERT_TRUE(games.add(game));
  const std::optional<std::string> page = games.page("p0001-1");
  ASSERT_TRUE(page);
  EXPECT_TRUE(has(*page, io::hash_text(game::play(experiments::resolved(game)).state_hash)));
}

TEST(StartedGames, AreForgottenOnRequest) {
  StartedGames games;
  for (const char* id : {"p0001-1", "p0001-2"}) games.add(short_scheduled_game(id, 1));
  games.forget("p0001-1");
  games.forget("p0009-1");
  EXPECT_FALSE(games.page("p0001-1"));
  EXPECT_TRUE(games.page("p0001-2"));
  EXPECT_FALSE(games.page("p0009-1"));
}

TEST(StartedGames, OfProgramsHaveNoPage) {
  StartedGames games;
  game::GameSettings game;
  game.b.program.command = {"my_team"};
  EXPECT_FALSE(games.add({"p0001-1", {}, 1, 1, experiments::SharedSettings(game)}));
  EXPECT_FALSE(games.page("p0001-1"));
}

}  // namespace
}  // namespace autoref::app
