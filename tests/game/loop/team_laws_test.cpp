// What teams know of the rules.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>

#include "game/loop/game.hpp"
#include "game/loop/team_controller.hpp"
#include "soccer/units.hpp"
#include "strategies/teams/dummy.hpp"

namespace autoref::game {
namespace {

// The context of each side's team.
std::map<Side, strategies::TeamContext> contexts_in(const GameConfiguration& game) {
  std::map<Side, strategies::TeamContext> contexts;
  const Game begun(
      game, nullptr,
      [&](const TeamConfiguration&,
          const strategies::TeamContext& context) -> std::unique_ptr<strategies::Strategy> {
        contexts.emplace(context.side, context);
        return std::make_unique<strategies::Dummy>();
      });
  return contexts;
}

TEST(TeamLaws, AreObeyedByTheTeamThatKnowsThem) {
  GameConfiguration game;
  game.b.laws = std::nullopt;
  const auto contexts = contexts_in(game);
  const RuleBook& known = contexts.at(Side::kWest).rules;
  EXPECT_TRUE(known.has(RuleId::kBotDribbledBallTooFar));
  EXPECT_DOUBLE_EQ(known.dribbling_m, 0.5);
  EXPECT_EQ(contexts.at(Side::kEast).rules, game.match.rules);
}

TEST(TeamLaws, DoNotHideWhatIsEnforced) {
  const auto contexts = contexts_in(GameConfiguration{});
  EXPECT_EQ(contexts.at(Side::kWest).enforced, RuleBook{}.in_force);
}

TEST(TeamContext, HasTheScatterOfTheLeastExactKicker) {
  GameConfiguration game;
  game.a.robots[2].kicker.direction_noise_deg = 4;
  game.a.robots[3].kicker.speed_noise = 0.2;
  const auto contexts = contexts_in(game);
  EXPECT_DOUBLE_EQ(contexts.at(Side::kWest).kicks.direction_rad, 4_deg);
  EXPECT_EQ(contexts.at(Side::kWest).kicks.speed, 0.2);
  EXPECT_DOUBLE_EQ(contexts.at(Side::kEast).kicks.direction_rad, 1.5_deg);
  EXPECT_EQ(contexts.at(Side::kEast).kicks.speed, 0.025);
}

TEST(TeamContext, HasTheTrueLatencyWithoutAnError) {
  const auto contexts = contexts_in(GameConfiguration{});
  EXPECT_DOUBLE_EQ(contexts.at(Side::kWest).latency_s, 5 / 60.0);
  EXPECT_DOUBLE_EQ(contexts.at(Side::kEast).latency_s, 5 / 60.0);
}

// The standard deviation over 400 draws has a standard error of 3.5 %.
TEST(TeamContext, HasALatencyOffByTheErrorInEachGameAndTeam) {
  double sum_s2 = 0;
  constexpr int kGames = 200;
  for (int seed = 1; seed <= kGames; ++seed) {
    GameConfiguration game;
    game.seed = static_cast<std::uint64_t>(seed);
    game.sim.latency_error_s = 10_ms;
    const auto contexts = contexts_in(game);
    EXPECT_NE(contexts.at(Side::kWest).latency_s, contexts.at(Side::kEast).latency_s);
    for (const Side side : kSides) sum_s2 += square(contexts.at(side).latency_s - 5 / 60.0);
  }
  EXPECT_NEAR(std::sqrt(sum_s2 / (2 * kGames)), 10_ms, 0.0015);
}

}  // namespace
}  // namespace autoref::game
