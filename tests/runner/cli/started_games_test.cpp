// Pages of games that a run has started.
#include "runner/cli/started_games.hpp"

#include <gtest/gtest.h>

#include "runner/game/game.hpp"
#include "runner/io/checksum.hpp"
#include "tests/runner/support/has_part.hpp"

namespace autoref::runner {
namespace {

ScheduledGame short_scheduled_game(const std::string& id, std::uint64_t seed) {
  GameSettings game;
  game.match.half_s = 2;
  game.seed = seed;
  return {id, {}, 1, 1, SharedSettings(game)};
}

TEST(StartedGames, HaveAPageOfTheSameGame) {
  StartedGames games;
  const ScheduledGame game = short_scheduled_game("p0001-1", 7);
  ASSERT_TRUE(games.add(game));
  const std::optional<std::string> page = games.page("p0001-1");
  ASSERT_TRUE(page);
  EXPECT_TRUE(has(*page, hash_text(play(resolved(game)).state_hash)));
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
  GameSettings game;
  game.b.program.command = {"my_team"};
  EXPECT_FALSE(games.add({"p0001-1", {}, 1, 1, SharedSettings(game)}));
  EXPECT_FALSE(games.page("p0001-1"));
}

}  // namespace
}  // namespace autoref::runner
