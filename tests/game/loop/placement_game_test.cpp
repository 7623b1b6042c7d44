// match.placement: games in which the teams place the ball.
#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

int count_of_event(const GameRecord& record, referee::Event event) {
  return record.events[static_cast<std::size_t>(event)];
}

GameConfiguration placed_by_teams(const std::string& a, const std::string& b) {
  GameConfiguration game = short_game_by("2026-b", 60, 5);
  game.a.strategy = a;
  game.b.strategy = b;
  game.match.placement = referee::PlacedBy::kTeams;
  return game;
}

TEST(PlacementGame, OfTeamsWithPlaybooksHasSuccessesOnly) {
  const GameRecord record = play(placed_by_teams("cobalt", "counter"));
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_GE(count_of_event(record, referee::Event::kPlacementSucceeded), 3);
  EXPECT_EQ(count_of_event(record, referee::Event::kPlacementFailed), 0);
}

TEST(PlacementGame, OfTeamsThatCannotPlaceTheBallEndsByItself) {
  const GameRecord record = play(placed_by_teams("basic", "basic"));
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.end_reason, EndReason::kTime);
  EXPECT_GE(count_of_event(record, referee::Event::kPlacementFailed), 2);
}

TEST(PlacementGame, IsOffByDefault) {
  EXPECT_EQ(value_at(GameSettings{}, "match.placement"), "simulator");
  GameSettings game;
  set_by_path(game, "match.placement", "teams");
  EXPECT_EQ(game.match.placement, referee::PlacedBy::kTeams);
}

}  // namespace
}  // namespace autoref::game
