#include "soccer/field.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"

namespace autoref {
namespace {

TEST(Field, HasThePapersSize) {
  const Field field;
  EXPECT_DOUBLE_EQ(field.half_length_m(), 3.025);  // paper, section 3: 6.05 m x 4.05 m
  EXPECT_DOUBLE_EQ(field.half_width_m(), 2.025);
  EXPECT_DOUBLE_EQ(field.half_goal_m(), 0.35);  // Laws 2014, single size
  EXPECT_DOUBLE_EQ(field.goal_opening_height_m, 0.155);
  EXPECT_DOUBLE_EQ(field.wall_x_m(), 3.7);
  EXPECT_DOUBLE_EQ(field.wall_y_m(), 2.7);
}

// Division A in 2026.
TEST(Field, MayHaveItsWallsFartherBehindTheGoalLines) {
  Field field;
  field.run_off_m = 0.3;
  EXPECT_DOUBLE_EQ(field.wall_x_m(), 3.325);
  field.goal_line_run_off_m = 0.6;
  EXPECT_DOUBLE_EQ(field.wall_x_m(), 3.625);
  EXPECT_DOUBLE_EQ(field.wall_y_m(), 2.325);
}

TEST(Field, PenaltyMarkLies750MmInFrontOfTheGoal) {
  EXPECT_TRUE(Field().penalty_mark_at(Side::kEast).isApprox(Vec2(2.275, 0)));
}

TEST(DefenceArea, OfQuarterCirclesReaches800MmFromTheGoal) {
  const Field field;
  EXPECT_NEAR(distance_to_defence_area(field, Side::kWest, {-2.225, 0}), 0, 1e-12);
  EXPECT_NEAR(distance_to_defence_area(field, Side::kWest, {-2.025, 0.17}), 0.2, 1e-12);
  EXPECT_NEAR(distance_to_defence_area(field, Side::kEast, {2.5, 0}), -0.275, 1e-12);
}

TEST(DefenceArea, OfQuarterCirclesIsRoundBesideTheStraightLine) {
  const Field field;  // straight line of 350 mm: the circle's centre is at y = 175 mm
  const Vec2 rim_m(3.025 - 0.8 * 0.6, 0.175 + 0.8 * 0.8);
  EXPECT_NEAR(distance_to_defence_area(field, Side::kEast, rim_m), 0, 1e-12);
}

TEST(DefenceArea, OfBoxShapeMeasuresToItsCorner) {
  Field field;
  field.length_m = 9;
  field.defence_area = {DefenceArea::Shape::kBox, 1.0, 2.0};
  EXPECT_NEAR(distance_to_defence_area(field, Side::kEast, {3.2, 1.4}), 0.5, 1e-12);
  EXPECT_NEAR(distance_to_defence_area(field, Side::kEast, {3.6, 0.0}), -0.1, 1e-12);
}

TEST(RobotHull, IsFlatInFrontAndRoundBehind) {
  const Vec2 centre_m(1, 1);
  const Vec2 north(0, 1);
  EXPECT_NEAR(distance_to_hull({1, 1.1}, centre_m, north), 0.025, 1e-12);
  EXPECT_NEAR(distance_to_hull({1, 0.9}, centre_m, north), 0.010, 1e-12);
  EXPECT_NEAR(distance_to_hull({1.03, 1.1}, centre_m, north), 0.025, 1e-12);
  EXPECT_NEAR(distance_to_hull({1.2, 1}, centre_m, north), 0.110, 1e-12);
  EXPECT_LT(distance_to_hull({1, 1.05}, centre_m, north), 0);
}

TEST(RobotHull, MeasuresToThePlatesCornerOutsideThePlate) {
  const Vec2 corner_m(kFrontDistance_m, kHalfPlate_m);
  EXPECT_NEAR(corner_m.norm(), kRobotRadius_m, 1e-12);
  const Vec2 outside_m = corner_m + Vec2(0.03, 0.004);
  EXPECT_NEAR(distance_to_hull(outside_m, {0, 0}, {1, 0}), (outside_m - corner_m).norm(), 1e-12);
}

}  // namespace
}  // namespace autoref
