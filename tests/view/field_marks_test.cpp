#include "view/field_marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "soccer/rules/rule_book.hpp"

namespace autoref::view {
namespace {

Field field_of_book(const char* name) { return find_game_setup(name)->field; }

// Sample points along the outline.
std::vector<Vec2> positions_on(const Outline& outline) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 10; ++i) {
    for (const MarkLine& line : outline.lines)
      points.push_back(line.from_m + i / 10.0 * (line.to_m - line.from_m));
    for (const MarkArc& arc : outline.arcs) {
      const double angle_rad = arc.from_rad + i / 10.0 * (arc.to_rad - arc.from_rad);
      points.push_back(arc.centre_m + arc.radius_m * heading_of(angle_rad));
    }
  }
  return points;
}

class AroundDefenceArea : public testing::TestWithParam<const char*> {};

TEST_P(AroundDefenceArea, HasTheRequestedDistanceEverywhere) {
  const Field field = field_of_book(GetParam());
  for (const Side side : kSides) {
    const Outline outline = around_defence_area(field, side, 0.2);
    ASSERT_EQ(outline.arcs.size(), 2U);
    for (const Vec2& position_m : positions_on(outline))
      EXPECT_NEAR(distance_to_defence_area(field, side, position_m), 0.2, 1e-9) << position_m;
  }
}

TEST_P(AroundDefenceArea, LiesInFrontOfTheGoalLine) {
  const Field field = field_of_book(GetParam());
  for (const Side side : kSides) {
    for (const Vec2& position_m : positions_on(around_defence_area(field, side, 0.2)))
      EXPECT_LE(std::abs(position_m.x()), field.half_length_m() + 1e-9) << position_m;
  }
}

INSTANTIATE_TEST_SUITE_P(Books, AroundDefenceArea, testing::Values("2014", "2026-b"),
                         [](const auto& book) {
                           return std::string(book.param) == "2014" ? "RoundArea" : "BoxArea";
                         });

TEST(FieldLines, MatchTheLeaguesVision) {
  // Four sides, two lines through the centre and both defence areas; the centre circle.
  EXPECT_EQ(field_lines(field_of_book("2014")).lines.size(), 8U);
  EXPECT_EQ(field_lines(field_of_book("2014")).arcs.size(), 5U);
  EXPECT_EQ(field_lines(field_of_book("2026-b")).lines.size(), 12U);
  EXPECT_EQ(field_lines(field_of_book("2026-b")).arcs.size(), 1U);
}

TEST(GoalWalls, RunFromPostToPostAlongTheBack) {
  const auto walls_m = goal_walls_m(Field{}, Side::kWest);
  EXPECT_EQ(walls_m[0], Vec2(-3.025, 0.35));
  EXPECT_NEAR(walls_m[1].x(), -3.205, 1e-9);
  EXPECT_EQ(walls_m[3], Vec2(-3.025, -0.35));
}

TEST(GoalWalls, GoOnToTheWallIn2026) {
  const auto walls_m = goal_walls_m(field_of_book("2026-a"), Side::kEast);
  EXPECT_EQ(walls_m.front(), Vec2(6, 0.9));
  EXPECT_EQ(walls_m.back(), Vec2(6, -0.9));
  for (const double y_m : {0.9, -0.9})
    EXPECT_EQ(std::count(walls_m.begin(), walls_m.end(), Vec2(6.6, y_m)), 1) << y_m;
  EXPECT_NEAR(walls_m[2].x(), 6.18, 1e-9);
  EXPECT_NEAR(walls_m[3].x(), 6.18, 1e-9);
}

}  // namespace
}  // namespace autoref::view
