// The simulator's walls keep every ball inside, so that each call of a boundary crossing is wrong.
#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::game {
namespace {

// In this game a robot chips the ball over a touch line, and cameras see it behind the wall.
TEST(BoundaryCrossingGame, HasNoCallForABallThatTheWallStops) {
  GameSettings settings;
  choose_rules("2026-a", settings);
  set_by_path(settings, "a.strategy", "cobalt");
  set_by_path(settings, "b.strategy", "counter");
  set_by_path(settings, "sim.camera", "realistic");
  settings.seed = 1;
  const GameRecord record = play(resolved(settings));
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.events[static_cast<std::size_t>(referee::Event::kBoundaryCrossing)], 0);
}

}  // namespace
}  // namespace autoref::game
