#include "referee/touch/touch_candidates.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::referee {
namespace {

// The gap of a ball at rest there, at a goal's corner.
double gap_at_m(const Field& field, const Vec2& ball_m) {
  return gap_to_goals_m(field, {ball_m, ball_m});
}

TEST(GapToGoals, EndsAtTheGoalsBack) {
  const Field field = find_game_setup("2014")->field;
  EXPECT_NEAR(gap_at_m(field, {3.025 + 0.1, 0.37 + 0.1}), 0.1 - kBallRadius_m, 1e-9);
  EXPECT_NEAR(gap_at_m(field, {3.025 + 0.48, 0.37}), 0.3 - kBallRadius_m, 1e-9);
}

TEST(GapToGoals, EndsAtTheWallIn2026) {
  const Field field = find_game_setup("2026-a")->field;
  EXPECT_NEAR(gap_at_m(field, {6.5, 0.92 + 0.1}), 0.1 - kBallRadius_m, 1e-9);
  EXPECT_NEAR(gap_at_m(field, {-6.5, -0.92 - 0.1}), 0.1 - kBallRadius_m, 1e-9);
}

}  // namespace
}  // namespace autoref::referee
