#include "referee/geometry/restarts.hpp"

#include <gtest/gtest.h>

namespace autoref::referee {
namespace {

const Field kPaperField;  // goal lines at x = 3.025 m, touch lines at y = 2.025 m
const RuleBook kRules;

void expect_at(const Vec2& position_m, const Vec2& expected_m) {
  EXPECT_NEAR(position_m.x(), expected_m.x(), 1e-12);
  EXPECT_NEAR(position_m.y(), expected_m.y(), 1e-12);
}

TEST(ThrowIn, IsTaken100MillimetresInsideTheTouchLine) {
  expect_at(throw_in_position(kPaperField, kRules, {1.2, 2.0465}), {1.2, 1.925});
  expect_at(throw_in_position(kPaperField, kRules, {-1.2, -2.0465}), {-1.2, -1.925});
}

TEST(ThrowIn, NearACornerStays100MillimetresOffTheGoalLine) {
  expect_at(throw_in_position(kPaperField, kRules, {3.04, 2.0465}), {2.925, 1.925});
}

TEST(CornerKick, IsTaken100MillimetresFromBothLines) {
  expect_at(corner_kick_position(kPaperField, kRules, Side::kWest, {3.0465, 0.9}), {2.925, 1.925});
  expect_at(corner_kick_position(kPaperField, kRules, Side::kEast, {-3.0465, -0.9}),
            {-2.925, -1.925});
}

TEST(GoalKick, IsTaken500MillimetresFromTheGoalLineAnd100FromTheTouchLine) {
  expect_at(goal_kick_position(kPaperField, kRules, Side::kEast, {3.0465, -0.9}), {2.525, -1.925});
}

TEST(GoalKick, FromTheExactMiddleTurnsWithTheField) {
  const Vec2 east = goal_kick_position(kPaperField, kRules, Side::kEast, {3.0465, 0});
  const Vec2 west = goal_kick_position(kPaperField, kRules, Side::kWest, {-3.0465, 0});
  expect_at(west, -east);
}

TEST(FreeKick, IsTakenWhereItHappened) {
  expect_at(free_kick_position(kPaperField, kRules, Side::kWest, {0.4, -0.3}), {0.4, -0.3});
  expect_at(free_kick_position(kPaperField, kRules, Side::kWest, {0.4, -2.5}), {0.4, -1.925});
}

TEST(FreeKick, OutOfTheOwnAreaIs600MillimetresFromTheGoalLine) {
  expect_at(free_kick_position(kPaperField, kRules, Side::kWest, {-2.8, 0.3}), {-2.425, 1.925});
}

TEST(FreeKick, NearTheOpponentsAreaIsMovedTo700MillimetresFromIt) {
  const Vec2 position_m = free_kick_position(kPaperField, kRules, Side::kWest, {2.0, 0.6});
  EXPECT_NEAR(distance_to_defence_area(kPaperField, Side::kEast, position_m), 0.7, 1e-12);
  EXPECT_EQ(position_m.y(), 0.6);
}

void expect_neutral_position_off_areas(const Vec2& stuck_m) {
  const Vec2 position_m = neutral_position(kPaperField, kRules, stuck_m);
  EXPECT_GE(distance_to_defence_area(kPaperField, Side::kWest, position_m), 0.7 - 1e-12);
  EXPECT_GE(distance_to_defence_area(kPaperField, Side::kEast, position_m), 0.7 - 1e-12);
  EXPECT_TRUE(is_on_field(kPaperField, position_m)) << position_m.transpose();
}

TEST(NeutralPosition, Is700MillimetresFromBothAreas) {
  expect_neutral_position_off_areas({2.9, 0.1});
  expect_neutral_position_off_areas({-2.0, -0.8});
  expect_neutral_position_off_areas({3.0, 2.0});
}

TEST(NeutralPosition, IsTheBallsPositionIfThatIsNeutral) {
  expect_at(neutral_position(kPaperField, kRules, {0.3, -1.0}), {0.3, -1.0});
}

TEST(NeutralPosition, KeepsClearOfBoxAreas) {
  Field field;
  field.length_m = 9;
  field.width_m = 6;
  field.defence_area = {DefenceArea::Shape::kBox, 1.0, 2.0};
  const Vec2 position_m = neutral_position(field, kRules, {4.0, 1.3});
  EXPECT_NEAR(distance_to_defence_area(field, Side::kEast, position_m), 0.7, 1e-12);
}

// 2026: "at least 0.2 meters distance to all field lines and 1 meter distance to either defense
// area", or "the closest valid position"; Division B: areas 1 m deep and 2 m wide.
class FreeKick2026 : public testing::TestWithParam<Side> {
 protected:
  // The position of a free kick for east, near its own area (parameter east) or near the opponents'
  // area (parameter west), rotated so that the nearby area is the east one.
  Vec2 position(const Vec2& where_m) const {
    const double turn = GetParam() == Side::kEast ? 1 : -1;
    return turn * free_kick_position(field, rules, Side::kEast, turn * where_m);
  }
  const RuleBook rules = find_rule_book("2026-b").value();
  const Field field = find_game_setup("2026-b")->field;
};

// The kicker's own area, and the opponents' area.
INSTANTIATE_TEST_SUITE_P(Areas, FreeKick2026, testing::ValuesIn(kSides));

TEST_P(FreeKick2026, IsOneMetreInFrontOfTheArea) { expect_at(position({3.0, 0.4}), {2.5, 0.4}); }
TEST_P(FreeKick2026, OrBesideIt) { expect_at(position({4.2, -1.9}), {4.2, -2.0}); }
TEST_P(FreeKick2026, OrOffItsCorner) { expect_at(position({3.2, 1.4}), {2.9, 1.8}); }
TEST_P(FreeKick2026, LeavesTheAreaTheShortestWay) {
  expect_at(position({3.7, 0.5}), {2.5, 0.5});
  expect_at(position({4.3, -0.9}), {4.3, -2.0});
}
TEST_P(FreeKick2026, Is200MillimetresInsideTheLines) {
  expect_at(position({4.45, 2.9}), {4.3, 2.8});
  expect_at(position({0.5, -3.1}), {0.5, -2.8});
}
TEST_P(FreeKick2026, IsWhereItHappenedIfThatIsValid) {
  expect_at(position({2.4, 0.4}), {2.4, 0.4});
}

TEST(Restarts2026, HaveTheirOwnInsets) {
  const RuleBook rules = find_rule_book("2026-b").value();
  const Field field = find_game_setup("2026-b")->field;
  expect_at(throw_in_position(field, rules, {1.2, 3.02}), {1.2, 2.8});
  expect_at(corner_kick_position(field, rules, Side::kWest, {4.52, 0.9}), {4.3, 2.8});
  expect_at(goal_kick_position(field, rules, Side::kEast, {4.52, -0.9}), {3.5, -2.8});
}

}  // namespace
}  // namespace autoref::referee
