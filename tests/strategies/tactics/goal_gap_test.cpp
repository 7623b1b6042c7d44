#include "strategies/tactics/keeper.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

Style covering_style() {
  Style style;
  style.keeper_fills_gap = 1;
  return style;
}

// A keeper, an opponent with the ball 2 m in front of the goal, and team-mates at the given points.
StagedPrediction staged_wall(const std::vector<Vec2>& wall_m, const Style& style = {}) {
  StagedPrediction stage(Play::kRunning, false, {}, style);
  stage.world.own(0, {-2.8, 0}).opponent(0, {-0.9, 0}).ball({-1, 0});
  for (const Vec2& position_m : wall_m)
    stage.world.own(static_cast<int>(stage.world.view.own.size()), position_m);
  stage.look();
  return stage;
}

constexpr KeeperShadow kShadow{0.13, 0, std::nullopt};

TEST(GapForKeeper, IsTheMiddleOfAGoalWithoutDefenders) {
  EXPECT_NEAR(gap_for_keeper_m(staged_wall({}).predicted, kShadow).value(), 0, 0.1);
}

// The robot at (-2, 0.1) shades the goal line from y = -0.03 to 0.43.
TEST(GapForKeeper, IsOnTheSideThatTheWallLeavesOpen) {
  const StagedPrediction left = staged_wall({{-2, 0.1}});
  EXPECT_LT(gap_for_keeper_m(left.predicted, kShadow).value(), -0.12);
  const StagedPrediction right = staged_wall({{-2, -0.1}});
  EXPECT_GT(gap_for_keeper_m(right.predicted, kShadow).value(), 0.12);
}

TEST(GapForKeeper, IsNowhereIfTheWallCoversTheWholeGoal) {
  const StagedPrediction stage = staged_wall({{-1.5, 0.1}, {-1.5, -0.1}});
  EXPECT_FALSE(gap_for_keeper_m(stage.predicted, kShadow).has_value());
}

TEST(GapForKeeper, IsNearerToTheShootersAim) {
  const StagedPrediction stage = staged_wall({});
  EXPECT_GT(gap_for_keeper_m(stage.predicted, {0.13, 0, 0.25}).value(), 0.1);
  EXPECT_LT(gap_for_keeper_m(stage.predicted, {0.13, 0, -0.25}).value(), -0.1);
}

TEST(GapForKeeper, IsNotLookedForIfTheBallIsInTheOtherHalf) {
  StagedPrediction stage = staged_wall({{-2, 0.1}});
  stage.world.ball({2, 0});
  EXPECT_FALSE(gap_for_keeper_m(stage.look(), kShadow).has_value());
}

TEST(KeeperPosition, CoversWhatTheWallLeavesOpenIfTheStyleSaysSo) {
  const std::vector<Vec2> wall_m = {{-2, 0.1}};
  const StagedPrediction usual = staged_wall(wall_m);
  const StagedPrediction covering = staged_wall(wall_m, covering_style());
  const auto y_of = [](const StagedPrediction& stage) {
    return keeper_position(stage.predicted, stage.predicted.robot(0)).position_m.y();
  };
  EXPECT_NEAR(y_of(usual), 0, 0.05);
  EXPECT_LT(y_of(covering), -0.1);
}

TEST(Threat, LeadsTheBallOfAnOpponentThatDribblesIt) {
  Style style;
  style.threat_lead_s = 0.2;
  StagedPrediction stage = staged_wall({}, style);
  TrackedRobot& opponent = stage.world.view.opponents[0];
  opponent.position_m = Vec2(-1, -kHeldBall_m);
  opponent.heading = {0, 1};
  opponent.velocity_mps = {0, 1.5};
  EXPECT_NEAR(stage.look().threat_m().y(), 0.3, 0.02);
  EXPECT_NEAR(stage.predicted.threat_m().x(), -1, 0.02);
}

TEST(Threat, IsTheBallByDefault) {
  StagedPrediction stage = staged_wall({});
  EXPECT_EQ(stage.look().threat_m(), stage.predicted.position_m());
}

}  // namespace
}  // namespace autoref::strategies
