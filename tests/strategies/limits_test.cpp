#include "strategies/skills/limits.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

constexpr double kFarBall_m = 100;  // where the ball does not matter

// Places all over the field, 0.13 m apart.
std::vector<Vec2> places_on(const Field& field) {
  std::vector<Vec2> places_m;
  for (double x = -field.half_length_m(); x < field.half_length_m(); x += 0.13) {
    for (double y = -field.half_width_m(); y < field.half_width_m(); y += 0.13)
      places_m.emplace_back(x, y);
  }
  return places_m;
}

class PermittedOnFieldOf : public testing::TestWithParam<const char*> {};

TEST_P(PermittedOnFieldOf, LeavesPlacesAloneThatBreakNoLimit) {
  const Field field = briefing_of(GetParam()).field;
  const Limits limits{false, 0.6, 0.3, false};
  const Vec2 ball_m(0.5, 0.5);
  for (const Vec2& place_m : places_on(field)) {
    if ((place_m - ball_m).norm() < 0.7) continue;
    if (distance_to_defence_area(field, Side::kWest, place_m) < 0.2) continue;
    if (distance_to_defence_area(field, Side::kEast, place_m) < 0.4) continue;
    ASSERT_EQ(permitted(field, place_m, ball_m, limits), place_m);
  }
}

TEST_P(PermittedOnFieldOf, LetsTheKeeperIntoItsArea) {
  const Field field = briefing_of(GetParam()).field;
  const Vec2 goal_m = field.goal_centre_m(Side::kWest);
  Limits keeper;
  keeper.may_enter_own_area = true;
  for (const Vec2& off_m : {Vec2(0.2, 0), Vec2(0.3, 0.2), Vec2(0.1, -0.4)}) {
    EXPECT_EQ(permitted(field, goal_m + off_m, {kFarBall_m, 0}, keeper), goal_m + off_m);
  }
}

class PermittedByRoundAreaOf : public PermittedOnFieldOf {};

TEST_P(PermittedByRoundAreaOf, KeepsARobotsHullOutOfItsOwnArea) {
  const Field field = briefing_of(GetParam()).field;
  for (const Vec2& place_m : places_on(field)) {
    const Vec2 p = permitted(field, place_m, {kFarBall_m, 0}, {});
    ASSERT_GE(distance_to_defence_area(field, Side::kWest, p), kRobotRadius_m)
        << place_m.transpose();
  }
}

TEST_P(PermittedByRoundAreaOf, KeepsItsDistanceFromTheirArea) {
  const Field field = briefing_of(GetParam()).field;
  Limits limits;
  limits.keep_from_area_m = 0.29;
  for (const Vec2& place_m : places_on(field)) {
    const Vec2 p = permitted(field, place_m, {kFarBall_m, 0}, limits);
    ASSERT_GE(distance_to_defence_area(field, Side::kEast, p), 0.29) << place_m.transpose();
  }
}

// From anywhere before the middle of a box, where the way out is straight ahead.
TEST_P(PermittedOnFieldOf, KeepsRobotsOutOfTheMiddleOfTheAreas) {
  const Field field = briefing_of(GetParam()).field;
  Limits limits;
  limits.keep_from_area_m = 0.29;
  for (double off_m = 0.9 * field.defence_area.depth_m; off_m > 0; off_m -= 0.1) {
    for (const Side side : kSides) {
      const Vec2 place_m = field.goal_centre_m(side) - Vec2(goal_sign(side) * off_m, 0);
      const Vec2 p = permitted(field, place_m, {kFarBall_m, 0}, limits);
      const double least_m = side == Side::kWest ? kRobotRadius_m : 0.29;
      ASSERT_GE(distance_to_defence_area(field, side, p), least_m) << place_m.transpose();
    }
  }
}

std::string name_of_book(const testing::TestParamInfo<const char*>& book) {
  std::string name = book.param;
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Books, PermittedOnFieldOf,
                         testing::Values("paper", "2014-double", "2026-b", "2026-a"), name_of_book);
INSTANTIATE_TEST_SUITE_P(Books, PermittedByRoundAreaOf, testing::Values("paper", "2014-double"),
                         name_of_book);

TEST(Permitted, MovesAPlaceOutOfTheAreaNoFartherThanItMust) {
  const Field field;
  for (const Vec2& place_m : places_on(field)) {
    const double inside_m = kRobotRadius_m - distance_to_defence_area(field, Side::kWest, place_m);
    const Vec2 p = permitted(field, place_m, {kFarBall_m, 0}, {});
    ASSERT_LE((p - place_m).norm(), std::max(0.0, inside_m) + 0.1) << place_m.transpose();
  }
}

TEST(Permitted, KeepsItsDistanceFromTheBall) {
  Limits limits;
  limits.keep_from_ball_m = 0.59;
  for (const Vec2& ball_m : {Vec2(0, 0), Vec2(1.2, -1), Vec2(-1, 0.7)}) {
    for (const Vec2& place_m : places_on(Field{})) {
      const Vec2 p = permitted(Field{}, place_m, ball_m, limits);
      ASSERT_GE((p - ball_m).norm(), 0.59) << place_m.transpose();
      if ((place_m - ball_m).norm() < 0.59) {
        ASSERT_LE((p - ball_m).norm(), 0.75) << place_m.transpose();
      }
    }
  }
}

TEST(Permitted, SendsARobotAtTheBallTowardsItsOwnGoal) {
  Limits limits;
  limits.keep_from_ball_m = 0.59;
  EXPECT_LT(permitted(Field{}, {0, 0}, {0, 0}, limits).x(), -0.5);
}

TEST(Permitted, KeepsTheHullInTheOwnHalf) {
  Limits limits;
  limits.own_half_only = true;
  for (const Vec2& place_m : places_on(Field{})) {
    const Vec2 p = permitted(Field{}, place_m, {kFarBall_m, 0}, limits);
    ASSERT_LE(p.x(), -kRobotRadius_m);
    ASSERT_NEAR(p.y(), place_m.y(), place_m.x() > -1 ? 1e-9 : 1.0);
  }
}

TEST(Permitted, StaysOnTheField) {
  const Field field;
  const Vec2 p = permitted(field, {9, -9}, {kFarBall_m, 0}, {});
  EXPECT_NEAR(p.x(), field.half_length_m(), 0.2);
  EXPECT_NEAR(p.y(), -field.half_width_m(), 0.2);
}

}  // namespace
}  // namespace autoref::strategies
