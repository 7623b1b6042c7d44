#include "game/loop/game_configuration.hpp"

#include <gtest/gtest.h>

namespace autoref::game {
namespace {

PerSide<std::string> names(const std::string& a, const std::string& b, Side a_plays) {
  GameConfiguration game;
  game.a.strategy = a;
  game.b.strategy = b;
  game.match.a_plays = a_plays;
  return shown_names(game);
}

TEST(ShownNames, AreTheStrategies) {
  EXPECT_EQ(names("zone", "basic", Side::kEast).values,
            (std::array<std::string, 2>{"basic", "zone"}));
}

TEST(ShownNames, IncludeTheTeamsLettersIfBothPlayTheSameStrategy) {
  EXPECT_EQ(names("basic", "basic", Side::kEast).values,
            (std::array<std::string, 2>{"basic (b)", "basic (a)"}));
}

}  // namespace
}  // namespace autoref::game
