#include "strategies/skills/limits.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

constexpr double kFarBall_m = 100;  // x of a ball so far away that it does not matter

// Positions 0.13 m apart all over the field and up to `beyond_m` outside it.
std::vector<Vec2> positions_on(const Field& field, double beyond_m = 0) {
  const double x_m = field.half_length_m() + beyond_m;
  const double y_m = field.half_width_m() + beyond_m;
  std::vector<Vec2> positions_m;
  for (double x = -x_m; x < x_m; x += 0.13) {
    for (double y = -y_m; y < y_m; y += 0.13) positions_m.emplace_back(x, y);
  }
  return positions_m;
}

// Those of the positions at which the condition does not hold.
template <typename Condition>
std::vector<Vec2> exceptions(std::vector<Vec2> positions_m, Condition holds_at) {
  std::erase_if(positions_m, holds_at);
  return positions_m;
}
const std::vector<Vec2> kNone_m;

Side half_of(const Vec2& position_m) { return position_m.x() < 0 ? Side::kWest : Side::kEast; }

// The required distances from both areas.
constexpr double kOffTheirs_m = 0.29;
Limits off_both_areas() {
  Limits limits;
  limits.keep_from_area_m = kOffTheirs_m;
  return limits;
}
double wanted_off_m(Side side) { return side == Side::kWest ? kRobotRadius_m : kOffTheirs_m; }

// Whether a position `path_m` from `position_m` is outside the area of `side` by the required
// distance.
bool is_out_within(const Field& field, Side side, const Vec2& position_m, double path_m) {
  constexpr int kDirections = 48;
  for (int i = 0; i < kDirections; ++i) {
    const Vec2 there_m = position_m + path_m * heading_of(i * 2 * kPi / kDirections);
    if (distance_to_defence_area(field, side, there_m) >= wanted_off_m(side)) return true;
  }
  return false;
}

class PermittedOnFieldOf : public testing::TestWithParam<const char*> {};

TEST_P(PermittedOnFieldOf, LeavesPermittedPositionsUnchanged) {
  const Field field = team_context_of(GetParam()).field;
  Limits limits;
  limits.keep_from_ball_m = 0.6;
  limits.keep_from_area_m = 0.3;
  const Vec2 ball_m(0.5, 0.5);
  const auto is_right = [&](const Vec2& position_m) {
    return (position_m - ball_m).norm() < 0.7 ||
           distance_to_defence_area(field, Side::kWest, position_m) < 0.2 ||
           distance_to_defence_area(field, Side::kEast, position_m) < 0.4 ||
           permitted(field, position_m, ball_m, limits) == position_m;
  };
  EXPECT_EQ(exceptions(positions_on(field), is_right), kNone_m);
}

TEST_P(PermittedOnFieldOf, LetsTheKeeperIntoItsArea) {
  const Field field = team_context_of(GetParam()).field;
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  Limits keeper;
  keeper.may_enter_own_area = true;
  const auto is_permitted = [&](const Vec2& position_m) {
    return permitted(field, position_m, {kFarBall_m, 0}, keeper) == position_m;
  };
  EXPECT_TRUE(is_permitted(goal_m + Vec2(0.2, 0)));
  EXPECT_TRUE(is_permitted(goal_m + Vec2(0.3, 0.2)));
  EXPECT_TRUE(is_permitted(goal_m + Vec2(0.1, -0.4)));
}

TEST_P(PermittedOnFieldOf, KeepsRobotsOutOfBothAreasWhereverTheyWantToBe) {
  const Field field = team_context_of(GetParam()).field;
  const auto is_right = [&](const Vec2& position_m) {
    const Vec2 p = permitted(field, position_m, {kFarBall_m, 0}, off_both_areas());
    return distance_to_defence_area(field, Side::kWest, p) >= wanted_off_m(Side::kWest) &&
           distance_to_defence_area(field, Side::kEast, p) >= wanted_off_m(Side::kEast);
  };
  EXPECT_EQ(exceptions(positions_on(field, field.run_off_m), is_right), kNone_m);
}

// The areas are convex: if no position on a circle around the wanted one is outside, then none
// within the circle is.
TEST_P(PermittedOnFieldOf, MovesAPositionOutOfAnAreaNoFartherThanNecessary) {
  const Field field = team_context_of(GetParam()).field;
  Limits limits = off_both_areas();
  limits.beyond_lines_m = field.run_off_m;
  const double beyond_m = std::min(0.5, field.run_off_m - kRobotRadius_m);
  const auto is_right = [&](const Vec2& position_m) {
    const Vec2 p = permitted(field, position_m, {kFarBall_m, 0}, limits);
    const double shorter_m = (p - position_m).norm() - 40_mm;
    return shorter_m < 0 || !is_out_within(field, half_of(position_m), position_m, shorter_m);
  };
  EXPECT_EQ(exceptions(positions_on(field, beyond_m), is_right), kNone_m);
}

INSTANTIATE_TEST_SUITE_P(Books, PermittedOnFieldOf,
                         testing::Values("paper", "2014-double", "2026-b", "2026-a"),
                         name_of_rule_book);

TEST(Permitted, KeepsRobotsInsideWallsThatStandNearTheLines) {
  const Field field = team_context_of("2026-b").field;
  Limits limits;
  limits.beyond_lines_m = 0.57;
  const Vec2 p = permitted(field, {2, 5}, {kFarBall_m, 0}, limits);
  EXPECT_NEAR(p.y(), 3.3 - kRobotRadius_m, 1e-9);
  EXPECT_NEAR(permitted(field, {5, 3}, {kFarBall_m, 0}, limits).x(), 4.8 - kRobotRadius_m, 1e-9);
}

// A robot between a ball at a touch line of 2026 and the wall cannot back away from the ball by 0.5
// m.
TEST(OffWalls, TurnsAlongAWallThatIsTooNear) {
  const Field field = team_context_of("2026-b").field;
  const Vec2 from_m(1, 3.1);
  const Vec2 along = off_walls(field, from_m, {0, 1}, 0.5);
  EXPECT_LE(from_m.y() + 0.5 * along.y(), 3.3 - kRobotRadius_m);
  EXPECT_GT(std::abs(along.x()), 0.9);
  EXPECT_EQ(off_walls(field, from_m, {0, -1}, 0.5), Vec2(0, -1));
  const Vec2 slanting = off_walls(field, from_m, heading_of(1.3), 0.5);
  EXPECT_GT(slanting.x(), 0.9);
}

TEST(OffWalls, ChangesNothingOnFieldsWithAWideRunOff) {
  const Field field = team_context_of("2014").field;
  EXPECT_EQ(off_walls(field, {0, field.wall_y_m() - 0.1}, {0, 1}, 0.5), Vec2(0, 1));
}

// 0.9 m in front of the west goal line and 0.3 m inside a side of the 2 m wide box.
TEST(Permitted, MovesAPositionInABoxToItsNearestSide) {
  const Field field = team_context_of("2026-b").field;
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  const Vec2 near_side_m = goal_m + Vec2(0.5, -0.7);
  const Vec2 p = permitted(field, near_side_m, {kFarBall_m, 0}, {});
  EXPECT_EQ(p.x(), near_side_m.x());
  EXPECT_NEAR(p.y(), -1.0 - kRobotRadius_m, 50_mm);
  const Vec2 near_front_m = goal_m + Vec2(0.9, -0.7);
  const Vec2 q = permitted(field, near_front_m, {kFarBall_m, 0}, {});
  EXPECT_NEAR(q.x(), goal_m.x() + 1.0 + kRobotRadius_m, 50_mm);
  EXPECT_EQ(q.y(), near_front_m.y());
}

class PermittedNearBall : public testing::TestWithParam<Vec2> {};

TEST_P(PermittedNearBall, KeepsItsDistanceAndIsNotMuchFarther) {
  Limits limits;
  limits.keep_from_ball_m = 0.59;
  const auto is_right = [&](const Vec2& position_m) {
    const double off_m = (permitted(Field{}, position_m, GetParam(), limits) - GetParam()).norm();
    const bool was_too_near = (position_m - GetParam()).norm() < 0.59;
    return off_m >= 0.59 && (off_m <= 0.75 || !was_too_near);
  };
  EXPECT_EQ(exceptions(positions_on(Field{}), is_right), kNone_m);
}

INSTANTIATE_TEST_SUITE_P(At, PermittedNearBall,
                         testing::Values(Vec2(0, 0), Vec2(1.2, -1), Vec2(-1, 0.7)), name_of_place);

TEST(Permitted, SendsARobotAtTheBallTowardsItsOwnGoal) {
  Limits limits;
  limits.keep_from_ball_m = 0.59;
  EXPECT_LT(permitted(Field{}, {0, 0}, {0, 0}, limits).x(), -0.5);
}

// Balls without space for a robot on some side: in front of, beside and behind areas, at lines and
// corners.
std::vector<Vec2> narrow_balls_of(const Field& field) {
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  const double depth_m = field.defence_area.depth_m;
  const Vec2 corner_m(field.half_length_m(), field.half_width_m());
  std::vector<Vec2> balls_m = {{0, 0}, corner_m, {0.3, -corner_m.y()}};
  for (const Vec2& off_m : {Vec2(depth_m + 0.1, 0), Vec2(depth_m + 0.3, 0.4), Vec2(0.1, 1.2),
                            Vec2(depth_m, depth_m), Vec2(0.3, 0.3), Vec2(depth_m, -depth_m)}) {
    balls_m.push_back(goal_m + off_m);
    balls_m.push_back(-goal_m - off_m);
  }
  return balls_m;
}

TEST_P(PermittedOnFieldOf, ByAllRespectsTheBallsCircleAndTheAreasAtOnce) {
  const Field field = team_context_of(GetParam()).field;
  Limits limits = off_both_areas();
  limits.keep_from_ball_m = 0.61;
  for (const Vec2& ball_m : narrow_balls_of(field)) {
    for (const Vec2& position_m : positions_on(field)) {
      const Vec2 p = permitted_by_all(field, position_m, ball_m, limits);
      ASSERT_GE((p - ball_m).norm(), 0.61) << position_m.transpose() << "; " << ball_m.transpose();
      ASSERT_LT((permitted(field, p, ball_m, limits) - p).norm(), 1e-9);  // the others, too
    }
  }
}

TEST_P(PermittedOnFieldOf, ByAllEqualsPermittedIfThatRespectsTheBallsCircle) {
  const Field field = team_context_of(GetParam()).field;
  Limits limits = off_both_areas();
  limits.keep_from_ball_m = 0.61;
  for (const Vec2& ball_m : narrow_balls_of(field)) {
    for (const Vec2& position_m : positions_on(field)) {
      const Vec2 p = permitted(field, position_m, ball_m, limits);
      if ((p - ball_m).norm() < 0.61) continue;
      ASSERT_EQ(permitted_by_all(field, position_m, ball_m, limits), p);
    }
  }
}

// 0.3 m in front of the area there is no space behind the ball: the position is beside it, not in
// front of it.
TEST(PermittedByAll, GoesAroundTheBallNoFartherThanNecessary) {
  const Field field;
  Limits limits;
  limits.keep_from_ball_m = 0.61;
  const Vec2 ball_m(-field.half_length_m() + 1.1, 0);
  const Vec2 p = permitted_by_all(field, {-field.half_length_m() + 0.9, 0.05}, ball_m, limits);
  EXPECT_LT(p.x(), ball_m.x());
  EXPECT_LT(distance_to_defence_area(field, Side::kWest, p), 0.2);
}

TEST(PermittedByAll, RespectsTheOwnHalfAndTheBallsCircleBeforeAKickoff) {
  Limits limits;
  limits.own_half_only = true;
  limits.keep_from_ball_m = 0.61;
  const auto is_right = [&](const Vec2& position_m) {
    const Vec2 p = permitted_by_all(Field{}, position_m, {0, 0}, limits);
    return p.norm() >= 0.61 && p.x() <= -kRobotRadius_m;
  };
  EXPECT_EQ(exceptions(positions_on(Field{}), is_right), kNone_m);
}

TEST(Permitted, KeepsTheHullInTheOwnHalf) {
  Limits limits;
  limits.own_half_only = true;
  const auto is_right = [&](const Vec2& position_m) {
    const Vec2 p = permitted(Field{}, position_m, {kFarBall_m, 0}, limits);
    const double aside_m = std::abs(p.y() - position_m.y());
    return p.x() <= -kRobotRadius_m && aside_m <= 1 && (aside_m <= 1e-9 || position_m.x() <= -1);
  };
  EXPECT_EQ(exceptions(positions_on(Field{}), is_right), kNone_m);
}

TEST(Permitted, StaysOnTheField) {
  const Field field;
  const Vec2 p = permitted(field, {9, -9}, {kFarBall_m, 0}, {});
  EXPECT_NEAR(p.x(), field.half_length_m(), 0.2);
  EXPECT_NEAR(p.y(), -field.half_width_m(), 0.2);
}

}  // namespace
}  // namespace autoref::strategies
