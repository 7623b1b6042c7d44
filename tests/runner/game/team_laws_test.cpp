// What teams know of the rules.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "runner/game/game.hpp"
#include "runner/game/team_maker.hpp"
#include "strategies/teams/dummy.hpp"

namespace autoref::runner {
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

}  // namespace
}  // namespace autoref::runner
