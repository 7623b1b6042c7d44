#include "strategies/tactics/penalty.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

TEST(PenaltyKicker, IsTheFieldPlayerNearestToTheMark) {
  StagedWorld world(Play::kPreparePenalty, true);
  const Vec2 mark_m = Field{}.penalty_mark_at(Side::kEast);
  world.own(0, mark_m).own(2, {0, 0}).own(5, {1, 0.5}).own(7, {-1, 0});
  EXPECT_EQ(penalty_kicker(world.view, mark_m), 2);
}

TEST(PenaltyKicker, IsTheOnlyRobotOrNobodyWithoutRobots) {
  StagedWorld world(Play::kPreparePenalty, true);
  EXPECT_EQ(penalty_kicker(world.view, {2, 0}), -1);
  world.own(4, {0, 0});
  EXPECT_EQ(penalty_kicker(world.view, {2, 0}), 0);
}

TEST(PenaltyRunUp, IsBehindTheBallWithoutTouchingIt) {
  const Waypoint waypoint = penalty_run_up({2, 0});
  EXPECT_LT(waypoint.position_m.x(), 2 - kHeldBall_m);
  EXPECT_GT(waypoint.position_m.x(), 1.5);
  EXPECT_EQ(waypoint.heading, Vec2(1, 0));
}

// The keeper must touch its line between the posts (Laws 14).
TEST(PenaltyKeeper, TouchesItsLineInTheMiddle) {
  const Field field;
  const Waypoint waypoint = penalty_keeper(field, field.penalty_mark_at(Side::kWest));
  EXPECT_LT(std::abs(waypoint.position_m.x() + field.half_length_m()), kRobotRadius_m);
  EXPECT_LT(std::abs(waypoint.position_m.y()), field.half_goal_m());
  EXPECT_GT(waypoint.heading.x(), 0.99);
}

void expect_spectators_behind_mark(double clearance_m, int order) {
  const Field field;
  const Vec2 ours_m(field.penalty_mark_at(Side::kEast));
  const Vec2 theirs_m(field.penalty_mark_at(Side::kWest));
  const Waypoint attacker = penalty_spectator(field, ours_m, clearance_m, true, order);
  const Waypoint defender = penalty_spectator(field, theirs_m, clearance_m, false, order);
  EXPECT_LE(attacker.position_m.x(), ours_m.x() - clearance_m - kRobotRadius_m);
  EXPECT_GE(defender.position_m.x(), theirs_m.x() + clearance_m + kRobotRadius_m);
  EXPECT_TRUE(is_on_field(field, attacker.position_m));
}

class PenaltySpectator : public testing::TestWithParam<int> {};

TEST_P(PenaltySpectator, KeepsItsHullBehindTheMarkByTheClearance) {
  expect_spectators_behind_mark(0.4, GetParam());
  expect_spectators_behind_mark(1.0, GetParam());
}

INSTANTIATE_TEST_SUITE_P(InOrder, PenaltySpectator, testing::Range(0, 10),
                         testing::PrintToStringParamName());

// Checks both teams' rows at once: the defenders see the mark turned by 180 degrees.
// The positions of five attackers and five defenders at a penalty in the opponents' half.
std::vector<Vec2> spectators_m() {
  const Field field;
  const Vec2 mark_m = field.penalty_mark_at(Side::kEast);
  std::vector<Vec2> positions_m;
  for (int order = 0; order < 5; ++order) {
    positions_m.push_back(penalty_spectator(field, mark_m, 0.4, true, order).position_m);
    positions_m.push_back(-penalty_spectator(field, -mark_m, 0.4, false, order).position_m);
  }
  return positions_m;
}

double least_distance_between_m(const std::vector<Vec2>& positions_m) {
  double least_m = 10;
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      least_m = std::min(least_m, (positions_m[i] - positions_m[k]).norm());
  }
  return least_m;
}

TEST(PenaltySpectators, DoNotOverlap) {
  EXPECT_GT(least_distance_between_m(spectators_m()), 2 * kRobotRadius_m)
      << testing::PrintToString(spectators_m());
}

}  // namespace
}  // namespace autoref::strategies
