#include "strategies/skills/openings.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

TrackedRobots robots_at(std::initializer_list<Vec2> positions_m) {
  TrackedRobots robots;
  for (const Vec2& position_m : positions_m)
    robots.push_back({static_cast<int>(robots.size()), position_m, Vec2(-1, 0), Vec2(0, 0), 0});
  return robots;
}

Opening opening_from(const Vec2& from_m, std::initializer_list<Vec2> opponents_m) {
  return widest_opening(Field{}, from_m, robots_at(opponents_m), {}, {});
}

TEST(WidestOpening, IsTheWholeOfAnEmptyGoal) {
  const Field field;
  const Opening opening = opening_from({field.half_length_m() - 1, 0}, {});
  EXPECT_LT((opening.target_m - field.goal_centre_m(Side::kEast)).norm(), 1e-6);
  EXPECT_NEAR(opening.half_width_m, field.half_goal_m(), 2 * kBallRadius_m);
  EXPECT_GT(opening.chance, 0.95);
}

// The keeper is so far to the left that the right post is open; its hull ends at y = -0.04.
TEST(WidestOpening, IsBesideARobotInTheGoal) {
  const Opening opening = opening_from({1, 0}, {{2.9, 0.05}});
  EXPECT_LT(opening.target_m.y(), -0.12);
  EXPECT_GT(opening.target_m.y(), -Field{}.half_goal_m());
  EXPECT_LT(opening.chance, opening_from({1, 0}, {}).chance);
}

TEST(WidestOpening, HasNoChanceThroughAFullWall) {
  const Opening opening = opening_from({1, 0}, {{2.9, -0.3}, {2.9, -0.1}, {2.9, 0.1}, {2.9, 0.3}});
  EXPECT_LT(opening.chance, 0.02);
}

TEST(WidestOpening, IsAlmostClosedFromTheEndOfTheGoalLine) {
  EXPECT_LT(opening_from({2.9, 1.9}, {}).chance, 0.1);
  EXPECT_LT(opening_from({3.0, 1.9}, {}).chance, 0.1);
}

TEST(WidestOpening, GetsSmallerWithTheDistance) {
  EXPECT_GT(opening_from({2, 0}, {}).chance, opening_from({0, 0}, {}).chance);
  EXPECT_GT(opening_from({0, 0}, {}).chance, opening_from({-2.5, 0}, {}).chance);
}

TEST(WidestOpening, IsMirroredInAMirroredWorld) {
  const Opening left = opening_from({1, 0.4}, {{2.9, 0.1}, {2, 0.5}, {2.2, -0.3}});
  const Opening right = opening_from({1, -0.4}, {{2.9, -0.1}, {2, -0.5}, {2.2, 0.3}});
  EXPECT_NEAR(left.target_m.y(), -right.target_m.y(), 1e-9);
  EXPECT_NEAR(left.chance, right.chance, 1e-9);
}

// At this distance half the goal spans the 1.5 degrees of the kick error: two kicks out of three
// score.
TEST(WidestOpening, HasTheChanceOfAKickWithOneAndAHalfDegreesOfError) {
  const double away_m = (Field{}.half_goal_m() - kBallRadius_m) / 0.0262;
  const double chance = opening_from({Field{}.half_length_m() - away_m, 0}, {}).chance;
  EXPECT_GT(chance, 0.5);
  EXPECT_LT(chance, 0.78);
}

// An opponent cannot step into the path of a shot over 0.3 m, but it can step into that of a shot
// over 2 m.
TEST(WidestOpening, CountsHowFarAnOpponentCanMoveMeanwhile) {
  const double near = opening_from({2.5, 0}, {{2.9, 0.2}}).half_width_m;
  const double far = opening_from({0, 0}, {{2.9, 0.2}}).half_width_m;
  EXPECT_GT(near, 1.3 * far);
}

TEST(WidestOpening, IsCoveredByTeamMatesButNotByTheShooter) {
  const TrackedRobots own = robots_at({{2.0, 0}});
  const Vec2 from_m(1.8, 0);
  const double mate = widest_opening(Field{}, from_m, {}, own, {8, -1}).half_width_m;
  const double self = widest_opening(Field{}, from_m, {}, own, {8, 0}).half_width_m;
  EXPECT_LT(mate, 0.5 * self);
}

TEST(PassSafety, IsOneWithNobodyThere) {
  EXPECT_EQ(pass_safety({-2, 0}, {2, 1}, 5, {}), 1);
  EXPECT_EQ(pass_safety({-2, 0}, {2, 0}, 5, robots_at({{0, 1.8}, {-2.9, 0}, {0, -1.8}})), 1);
}

TEST(PassSafety, IsZeroWithAnOpponentInThePath) {
  EXPECT_EQ(pass_safety({-2, 0}, {2, 0}, 5, robots_at({{-1.5, 0.05}})), 0);
  EXPECT_EQ(pass_safety({-2, 0}, {2, 0}, 5, robots_at({{0.0, 0.05}})), 0);
  EXPECT_EQ(pass_safety({-2, 0}, {2, 0}, 5, robots_at({{1.0, 0.05}})), 0);
}

TEST(PassSafety, GrowsWithTheDistanceOfAnOpponentFromThePath) {
  const auto safety = [](double aside_m) {
    return pass_safety({-2, 0}, {2, 0}, 5, robots_at({{0, aside_m}}));
  };
  EXPECT_GE(safety(0.1), 0);
  EXPECT_GE(safety(0.3), safety(0.1));
  EXPECT_GE(safety(0.5), safety(0.3));
  EXPECT_GE(safety(0.7), safety(0.5));
  EXPECT_GE(safety(0.9), safety(0.7));
  EXPECT_EQ(safety(0.9), 1);
}

// A ball kicked at 5 m/s takes 0.48 s for 2 m. An opponent that starts 0.08 s after the kick with 3
// m/s^2 moves 0.23 m in that time.
TEST(PassSafety, CountsHowFarAnOpponentMovesWhileTheBallRolls) {
  const double block_m = kRobotRadius_m + kBallRadius_m;
  const auto safety = [](double aside_m) {
    return pass_safety({-2, 0}, {0.2, 0}, 5, robots_at({{0, aside_m}}));
  };
  EXPECT_EQ(safety(block_m + 0.15), 0);
  EXPECT_EQ(safety(block_m + 0.45), 1);
}

TEST(PassSafety, IsLessIfAnOpponentHasTimeToIntercept) {
  const double at_start = pass_safety({-2, 0}, {2, 0}, 5, robots_at({{-1.7, 0.3}}));
  const double at_end = pass_safety({-2, 0}, {2, 0}, 5, robots_at({{1.7, 0.3}}));
  EXPECT_GT(at_start, at_end + 0.3);
}

}  // namespace
}  // namespace autoref::strategies
