// `basic` at penalties; the test gives the referee's commands.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/staged_game.hpp"

namespace autoref::game {
namespace {

constexpr RobotId kEastKeeper{Side::kEast, 0};

// `basic` against itself, with the ball on the penalty mark in front of the east goal and a kick
// prepared for the west.
struct Penalty : StagedGame {
  explicit Penalty(std::size_t robots = 6, const std::string& rules = "2014")
      : StagedGame({"basic", robots, {}}, {"basic", robots, {}}, find_rule_book(rules).value(), 1,
                   find_game_setup(rules)->field) {
    signal.placement = Placement{mark_m(), false};
    run(4);
    command(CommandKind::kPreparePenalty, Side::kWest);
    run(8);
  }
  Vec2 mark_m() const { return field.penalty_mark_at(Side::kEast); }
  void start() {
    command(CommandKind::kNormalStart);
    signal.placement.reset();
  }
  // Counts robots with part of their hull less than `room_m` behind the mark's line.
  int too_near(double room_m) const {
    int count = 0;
    for (const Side side : kSides) {
      for (const sim::RobotState& robot : robots(side)) {
        count += robot.position_m.x() + kRobotRadius_m > mark_m().x() - room_m ? 1 : 0;
      }
    }
    return count;
  }
};

TEST(BasicAtAPenalty, LeavesOnlyKickerAndKeeperNearTheMark) {
  for (const auto& [rules, room_m] : {std::pair("2014", 0.4), std::pair("2026-b", 1.0)}) {
    Penalty penalty(6, rules);
    EXPECT_EQ(penalty.too_near(room_m), 2) << rules;
    penalty.start();
    const Vec2 mark_m = penalty.mark_m();
    EXPECT_TRUE(
        penalty.happens(10, [&] { return (penalty.ball().position_m - mark_m).norm() > 0.05; }));
    EXPECT_EQ(penalty.too_near(room_m), 2) << rules;
  }
}

TEST(BasicAtAPenalty, KeepsItsKeeperOnTheLineUntilTheKick) {
  Penalty penalty;
  penalty.start();
  double farthest_m = 0;
  penalty.happens(10, [&] {
    const Vec2 keeper_m = penalty.robot(kEastKeeper).position_m;
    farthest_m = std::max(farthest_m, penalty.field.half_length_m() - keeper_m.x());
    EXPECT_LT(std::abs(keeper_m.y()), penalty.field.half_goal_m() - kRobotRadius_m);
    return (penalty.ball().position_m - penalty.mark_m()).norm() > 0.05;
  });
  EXPECT_LT(farthest_m, kFrontDistance_m);
}

TEST(BasicAtAPenalty, ShootsAtTheGoalWithinTenSeconds) {
  Penalty penalty;
  penalty.start();
  ASSERT_TRUE(penalty.happens(10, [&] { return penalty.ball().velocity_mps.norm() > 3; }));
  const Vec2 ball_mps = penalty.ball().velocity_mps;
  const double path_m = penalty.field.half_length_m() - penalty.ball().position_m.x();
  const double y = penalty.ball().position_m.y() + ball_mps.y() / ball_mps.x() * path_m;
  EXPECT_LT(std::abs(y), penalty.field.half_goal_m());
}

TEST(BasicAtAPenalty, StandsStillOnceItIsPrepared) {
  Penalty penalty;
  const auto before = penalty.world.state();
  penalty.run(1);
  for (const Side side : kSides) {
    for (std::size_t i = 0; i < before.robots[side].size(); ++i) {
      const Vec2 moved_m = penalty.robots(side)[i].position_m - before.robots[side][i].position_m;
      EXPECT_LT(moved_m.norm(), 15_mm) << name_of(side) << i;
    }
  }
}

TEST(BasicAtAPenalty, WorksWithOneRobotPerSide) {
  Penalty penalty(1);
  penalty.start();
  EXPECT_TRUE(penalty.happens(10, [&] { return penalty.ball().velocity_mps.norm() > 3; }));
}

}  // namespace
}  // namespace autoref::game
