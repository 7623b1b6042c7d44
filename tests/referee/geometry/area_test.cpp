#include "referee/geometry/area.hpp"

#include <gtest/gtest.h>

#include "soccer/rules/rule_book.hpp"

namespace autoref::referee {
namespace {

// The paper's field: west's area ends 0.8 m in front of x = -3.025, with a straight part of 0.35 m.
RobotObservation robot_at(const Vec2& at_m, const Vec2& heading) { return {1, at_m, heading}; }

TEST(HullToArea, IsTheCentresDistanceMinus90MillimetresForTheRoundHull) {
  EXPECT_NEAR(hull_to_area_m(Field{}, Side::kWest, robot_at({-2.025, 0}, {1, 0})), 0.11, 1e-9);
  EXPECT_NEAR(hull_to_area_m(Field{}, Side::kEast, robot_at({2.025, 0}, {-1, 0})), 0.11, 1e-9);
}

TEST(HullToArea, IsTheCentresDistanceMinus75MillimetresForTheFlatFront) {
  EXPECT_NEAR(hull_to_area_m(Field{}, Side::kWest, robot_at({-2.025, 0}, {-1, 0})), 0.125, 1e-9);
}

TEST(HullOutOfArea, IsMeasuredToTheFarthestPoint) {
  EXPECT_NEAR(hull_out_of_area_m(Field{}, Side::kWest, robot_at({-2.325, 0}, {-1, 0})), -0.01,
              1e-9);
  EXPECT_NEAR(hull_out_of_area_m(Field{}, Side::kWest, robot_at({-2.325, 0}, {1, 0})), -0.025,
              1e-9);
  EXPECT_NEAR(hull_out_of_area_m(Field{}, Side::kEast, robot_at({2.305, 0}, {1, 0})), 0.01, 1e-9);
}

// At a round line the corners of the front plate are farthest: sqrt((r + 75)^2 + 49.75^2) mm from
// the circle's centre.
TEST(HullOutOfArea, IsMeasuredToTheFrontsCornersAtARoundLine) {
  const Vec2 corner_m(-3.025, 0.175);
  const double root = 0.7071067811865476;
  const Vec2 direction(root, root);
  const double out_m =
      hull_out_of_area_m(Field{}, Side::kWest, robot_at(corner_m + 0.7 * direction, direction));
  EXPECT_NEAR(out_m, 0.776595133 - 0.8, 1e-6);
}

TEST(HullOutOfArea, TreatsFrontAndSideOfABoxSeparately) {
  const Field field = find_game_setup("2026-b")->field;  // 1 m deep in front of x = -4.5, 2 m wide
  // The centre is 80 mm behind the front line, towards which the flat front points, and 85 mm
  // inside the side line.
  const double out_m = hull_out_of_area_m(field, Side::kWest, robot_at({-3.58, 0.915}, {1, 0}));
  EXPECT_NEAR(out_m, 0.005, 1e-9);
}

}  // namespace
}  // namespace autoref::referee
