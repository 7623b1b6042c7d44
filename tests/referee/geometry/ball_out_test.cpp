#include "referee/geometry/ball_out.hpp"

#include <gtest/gtest.h>

namespace autoref::referee {
namespace {

// The paper's field: F_x = 3.025 m, F_y = 2.025 m, b_r = 21.5 mm, G_w = 0.35 m, G_h = 0.155 m.
constexpr double kOutX_m = 3.0465;
constexpr double kOutY_m = 2.0465;
const Field kField;

TEST(BallLeftField, IsNotCalledWhileTheBallTouchesTheLine) {
  EXPECT_FALSE(is_out_of_field(kField, {kOutX_m - 1e-6, 0}));
  EXPECT_FALSE(is_out_of_field(kField, {0, kOutY_m - 1e-6}));
  EXPECT_TRUE(is_out_of_field(kField, {kOutX_m + 1e-6, 0}));
  EXPECT_TRUE(is_out_of_field(kField, {0, kOutY_m + 1e-6}));
}

TEST(BallLeftField, IsCalledAtAllFourLines) {
  EXPECT_TRUE(is_out_of_field(kField, {-3.06, 0}));
  EXPECT_TRUE(is_out_of_field(kField, {0, -2.06}));
}

TEST(Intersection, IsThePapersFormula) {
  // The line from (1, 2) to (3, 6) meets x = 2 at y = 4.
  EXPECT_DOUBLE_EQ(*intersection(1, 2, 3, 6, 2), 4);
  EXPECT_FALSE(intersection(1, 2, 1, 6, 2).has_value());
}

TEST(Exit, IsOverTheTouchLineIfCxIsInside) {
  // Figure 4a: over the touch line first, then past the corner of the expanded field.
  const Exit exit = find_exit(kField, {2.95, 2.00}, {3.06, 2.11});
  EXPECT_EQ(exit.line, ExitLine::kTouch);
  EXPECT_NEAR(exit.point_m.x(), 2.9965, 1e-12);
  EXPECT_NEAR(exit.point_m.y(), kOutY_m, 1e-12);
}

TEST(Exit, IsOverTheGoalLineIfCxIsOutside) {
  const Exit exit = find_exit(kField, {3.00, 1.95}, {3.11, 2.06});  // figure 4b
  EXPECT_EQ(exit.line, ExitLine::kGoal);
  EXPECT_NEAR(exit.point_m.x(), kOutX_m, 1e-12);
  EXPECT_NEAR(exit.point_m.y(), 1.9965, 1e-12);
}

TEST(Exit, AlongXIsOverTheGoalLine) {
  const Exit exit = find_exit(kField, {-3.00, 0.8}, {-3.10, 0.8});
  EXPECT_EQ(exit.line, ExitLine::kGoal);
  EXPECT_EQ(exit.point_m, Vec2(-kOutX_m, 0.8));
}

TEST(Exit, AlongYIsOverTheTouchLine) {
  const Exit exit = find_exit(kField, {1.5, -2.00}, {1.5, -2.10});
  EXPECT_EQ(exit.line, ExitLine::kTouch);
  EXPECT_EQ(exit.point_m, Vec2(1.5, -kOutY_m));
}

TEST(Exit, IgnoresALineThatOnlyTheExtendedPathMeets) {
  // The ball rolls inwards along y and leaves over the goal line; extended backwards, its path
  // meets the touch line at c_x = 2.97, inside.
  const Exit exit = find_exit(kField, {3.03, 0.9}, {3.05, 0.5});
  EXPECT_EQ(exit.line, ExitLine::kGoal);
}

TEST(Exit, OfABallFirstSeenOutsideIsOverTheLineItIsFartherBeyond) {
  EXPECT_EQ(find_exit(kField, {3.10, 2.40}, {3.11, 2.41}).line, ExitLine::kTouch);
  EXPECT_EQ(find_exit(kField, {3.40, 2.10}, {3.41, 2.11}).line, ExitLine::kGoal);
  const Exit exit = find_exit(kField, {3.4, 0.5}, {3.4, 0.5});
  EXPECT_EQ(exit.point_m, Vec2(kOutX_m, 0.5));
}

TEST(Exit, TurnsWithTheField) {
  const Exit exit = find_exit(kField, {2.95, 2.00}, {3.06, 2.11});
  const Exit turned = find_exit(kField, {-2.95, -2.00}, {-3.06, -2.11});
  EXPECT_EQ(turned.line, exit.line);
  EXPECT_EQ(turned.point_m, Vec2(-exit.point_m));
}

TEST(BallInGoal, NeedsTheWholeBallBehindTheLine) {
  EXPECT_TRUE(is_in_goal(kField, {kOutX_m + 1e-6, 0}, 0));
  EXPECT_FALSE(is_in_goal(kField, {kOutX_m - 1e-6, 0}, 0));
  EXPECT_TRUE(is_in_goal(kField, {-3.1, 0}, 0));
}

TEST(BallInGoal, NeedsTheBallBetweenThePosts) {
  EXPECT_TRUE(is_in_goal(kField, {3.1, 0.349}, 0));
  EXPECT_FALSE(is_in_goal(kField, {3.1, 0.351}, 0));
  EXPECT_FALSE(is_in_goal(kField, {3.1, -0.351}, 0));
}

TEST(BallInGoal, NeedsTheBallsCentreBelowTheBar) {
  // The bar is at G_h = 155 mm, and the ball's centre 21.5 mm above its lowest point.
  EXPECT_TRUE(is_in_goal(kField, {3.1, 0}, 0.133));
  EXPECT_FALSE(is_in_goal(kField, {3.1, 0}, 0.134));
}

}  // namespace
}  // namespace autoref::referee
